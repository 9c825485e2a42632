#pragma once

#include <span>

#include "paper/flaps.h"

namespace foldwright::testing {

/// How near the outline of a piece, with its flaps, comes to itself across what is cut away.
struct OutlineGaps {
  double length = 0;  ///< of the outline, mm
  double close = 0;   ///< of it, with another line less than 1 mm straight ahead, but not upon it
  double corner = 0;  ///< of that, where both lines belong to faces that meet in a corner there
  double hair = 0;    ///< of that, what is less than 0.2 mm away

  void operator+=(const OutlineGaps& other);
};

/// Looks outwards from the outline every 0.25 mm. `net`: in mm. Quadratic in the cuts.
OutlineGaps outline_gaps(const Net& net, std::span<const Flap> flaps);

}  // namespace foldwright::testing
