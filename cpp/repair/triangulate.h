#pragma once

#include <array>
#include <span>
#include <vector>

#include "geometry/vec.h"

namespace foldwright {

/// Cuts a polygon into triangles with the polygon's winding; corners count from 0.
///
/// Quads get the diagonal that leaves the flatter pair of triangles (the inner one of a concave
/// quad); of equally flat pairs, as in any planar convex quad, that of the shorter diagonal, and of
/// equally long ones the one at corner 0. Larger polygons are clipped ear by ear, best shaped ear
/// first, in the plane of their Newell normal; concave and moderately bent ones come out right.
/// Where no ear is left (the polygon crosses itself) the flattest corner is cut off all the same,
/// so that there are always n - 2 triangles; some of them may have no area. Needles between corners
/// in line give their longest edge for the other diagonal.
/// Quadratic time: 10,000 corners take about a second. \pre at least 3 corners
std::vector<std::array<int, 3>> triangulate(std::span<const Vec3> polygon);

}  // namespace foldwright
