#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace foldwright {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;

/// z component of the cross product of two plane vectors: twice the signed area they span.
inline double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

}  // namespace foldwright
