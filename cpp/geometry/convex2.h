#pragma once

#include <span>

#include "geometry/box.h"
#include "geometry/vec.h"

namespace foldwright {

/// Box of some points. \pre there is one
Box2 box_of(std::span<const Vec2> points);

/// Whether the interiors of two convex, counter-clockwise polygons overlap by more than
/// `tolerance`, a length; the same test as `triangles_overlap` for any number of corners.
bool convex_overlap(std::span<const Vec2> a, std::span<const Vec2> b, double tolerance);

}  // namespace foldwright
