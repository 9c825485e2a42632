#pragma once

#include <algorithm>
#include <array>

#include "geometry/box.h"
#include "geometry/vec.h"

namespace foldwright {

/// Triangle in the plane, corners counter-clockwise.
using Triangle2 = std::array<Vec2, 3>;

inline Box2 box_of(const Triangle2& t) {
  const auto [min_x, max_x] = std::minmax({t[0].x(), t[1].x(), t[2].x()});
  const auto [min_y, max_y] = std::minmax({t[0].y(), t[1].y(), t[2].y()});
  return {{min_x, min_y}, {max_x, max_y}};
}

/// Whether the interiors of two counter-clockwise triangles overlap by more than `tolerance`.
///
/// Separating axes: they do not overlap when some edge of one has the whole other triangle on its
/// outer side, up to a depth of `tolerance` (a length). Touching along edges or in corners is no
/// overlap. In the plane the edge normals of both triangles are all axes there are, so the test is
/// exact up to rounding.
bool triangles_overlap(const Triangle2& a, const Triangle2& b, double tolerance);

/// Area of the intersection of two counter-clockwise triangles, by clipping one with the other
/// (Sutherland, Hodgman). Independent of `triangles_overlap`, for verification.
double intersection_area(const Triangle2& a, const Triangle2& b);

}  // namespace foldwright
