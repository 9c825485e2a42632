#pragma once

#include <span>
#include <vector>

#include "geometry/rigid_motion.h"

namespace foldwright {

/// Pieces may stick out of a sheet by this many millimetres: what is lost to rounding when a piece
/// that just fits is scaled, turned and moved, and what flaps at the sheet's edge may touch it by.
inline constexpr double kFitTolerance = 1e-5;

/// Width and height, in whatever unit the points have.
struct Extent {
  double width = 0, height = 0;
};

/// A way to turn a piece, by the angle with cosine `c` and sine `s`, and the size of its box then.
struct Turn {
  double c = 1, s = 0;
  Extent box;
};

/// Convex hull, counter-clockwise, without points on its edges (Andrew's monotone chain).
std::vector<Vec2> convex_hull(std::vector<Vec2> points);

/// The turns worth trying for a piece with this convex hull: each edge along either axis, since a
/// smallest enclosing box has a side on the hull, and steps of 3 degrees, since a long thin piece
/// fits a sheet best along its diagonal. \pre hull has three points or more
std::vector<Turn> upright_turns(std::span<const Vec2> hull);

/// Turns a piece with this hull, and moves its box to (0, 0).
RigidMotion2 turn_to_origin(std::span<const Vec2> hull, const Turn& turn);

/// The same turn of other points.
Turn turned(std::span<const Vec2> points, const Turn& turn);

/// Whether a box fits a room, both in mm and up to `kFitTolerance`.
bool fits(const Extent& box, const Extent& room);

}  // namespace foldwright
