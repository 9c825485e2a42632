#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "paper/flap_cover.h"

namespace foldwright {

/// How flaps may look; millimetres and radians.
struct FlapShape {
  double height = 5;  ///< of a full flap
  double least = 2;   ///< narrower ones hold no glue; at most `height`
  /// Of the sides at the two ends of the base, at most; 60 degrees.
  std::array<double, 2> angles = {1.0471975511965976, 1.0471975511965976};
};

/// A flap over its base from (0, 0) to (length, 0), with feet at x = `foot[0]` and `foot[1]` and a
/// top from `top[0]` to `top[1]` at y = `height`.
struct Trapezoid {
  double height;
  double foot[2], top[2];

  /// Counter-clockwise from the first foot.
  std::array<Vec2, 4> corners() const;
};

/// The room above the base of a flap: per bin of equal width the height up to which it is free.
struct RoomProfile {
  double length;  ///< of the base
  double most;    ///< height where nothing is in the way
  std::vector<double> room;

  double bin() const { return length / static_cast<double>(room.size()); }
};

/// Width of bins that is fine enough to compare nets by.
inline constexpr double kCoarseBin = 0.33;

/// Width of bins that loses hardly any room next to slanted edges; mm, less than scissors can tell.
inline constexpr double kFineBin = 0.1;

/// A profile of a base that has room of height `most` everywhere; `bin`: width of its bins, about.
RoomProfile open_room(double length, double most, double bin = kCoarseBin);

/// Lowers a profile below a convex polygon in the coordinates of the base, less a gap that keeps
/// scissors and glue off. What lies below the base is not looked at. Linear in its corners and the
/// bins.
void lower_below(RoomProfile& profile, std::span<const Vec2> polygon);

/// Lowers a profile below all borders of a cover but those at the ends of the base.
void lower_below(RoomProfile& profile, const FlapCover& cover);

/// The highest flap, and of those the one with the longest top, that lies below the profile and
/// between the borders that lean in from the ends of its base (see `FlapCover`); none if not even
/// the least does. Its feet stand as far apart as the profile allows. Heights go down in steps of
/// half a millimetre.
std::optional<Trapezoid> best_flap(const RoomProfile& profile, const std::array<double, 2>& lean,
                                   const FlapShape& shape);

/// The shortest edge on which the least flap stands.
double shortest_base(const FlapShape& shape);

}  // namespace foldwright
