#pragma once

#include <span>
#include <utility>
#include <vector>

#include "repair/triangle_soup.h"

namespace foldwright {

/// Bodies that run through each other or themselves.
struct Crossings {
  std::vector<std::pair<int, int>> pairs;  ///< of bodies, the lower first, ascending
  std::vector<int> bodies;                 ///< that run through themselves, ascending
  bool checked = true;                     ///< false when the surface is too large to look
};

/// Looks for faces that cross by more than a touch (`faces_cross`). Bodies that touch, in whatever
/// way, or that lie within each other do not cross. `bodies`: per face its body, from 0.
/// Near-linear; surfaces of more than 200,000 faces are not looked at, which would take seconds.
Crossings find_crossings(const TriangleSoup& soup, std::span<const int> bodies);

}  // namespace foldwright
