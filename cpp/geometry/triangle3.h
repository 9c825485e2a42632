#pragma once

#include <array>

#include "geometry/box.h"
#include "geometry/rigid_motion3.h"
#include "geometry/triangle2.h"

namespace foldwright {

/// Triangle in space.
using Triangle3 = std::array<Vec3, 3>;

Box3 box_of(const Triangle3& t);

/// The triangle of the plane z = 0 moved to its place in space.
Triangle3 moved(const RigidMotion3& motion, const Triangle2& t);
Triangle3 moved(const RigidMotion3& motion, const Triangle3& t);

/// Each side moved inwards by `depth`: scaled about the incentre by 1 - depth / r, r the inradius,
/// but by no less than `least`.
Triangle2 eroded(const Triangle2& t, double depth, double least);

/// Whether two triangles have a point in common, up to rounding.
///
/// Separating axes: the normals of both planes, the cross products of their edges, and for
/// triangles in one plane the normals of their edges in it.
bool triangles_meet(const Triangle3& a, const Triangle3& b);

/// Lower bound of the distance of two triangles, by the same axes; not positive when they meet.
/// Stops at the first axis with a gap of more than `enough`. It is at least about half of the
/// distance, since some axis is that close to the line between the nearest points.
double separation(const Triangle3& a, const Triangle3& b, double enough);

}  // namespace foldwright
