#pragma once

#include <cmath>

#include "geometry/rigid_motion.h"

namespace foldwright {

/// Orientation-preserving rigid motion of space: x -> R x + t, R as a unit quaternion.
struct RigidMotion3 {
  Eigen::Quaterniond r = Eigen::Quaterniond::Identity();
  Vec3 t = Vec3::Zero();

  Vec3 operator()(const Vec3& p) const { return r * p + t; }

  /// Applies `b` first, then `a`; the rotation is renormalised, as in the plane.
  friend RigidMotion3 operator*(const RigidMotion3& a, const RigidMotion3& b) {
    return {(a.r * b.r).normalized(), a(b.t)};
  }

  RigidMotion3 inverse() const {
    const Eigen::Quaterniond back = r.conjugate();
    return {back, -(back * t)};
  }
};

/// A motion of the plane z = 0, seen in space.
inline RigidMotion3 in_space(const RigidMotion2& motion) {
  // Half the angle, from whichever of sine and cosine does not cancel.
  double w, z;
  if (motion.c >= 0) {
    w = std::sqrt((1 + motion.c) / 2);
    z = motion.s / (2 * w);
  } else {
    z = std::copysign(std::sqrt((1 - motion.c) / 2), motion.s);
    w = motion.s / (2 * z);
  }
  return {Eigen::Quaterniond(w, 0, 0, z).normalized(), {motion.t.x(), motion.t.y(), 0}};
}

/// Turns by `angle` radians about the line through `point` along the unit vector `axis`.
inline RigidMotion3 turn_about(const Vec3& point, const Vec3& axis, double angle) {
  const double half = angle / 2;
  const Vec3 v = std::sin(half) * axis;
  const Eigen::Quaterniond r(std::cos(half), v.x(), v.y(), v.z());
  return {r, point - r * point};
}

}  // namespace foldwright
