#pragma once

#include <cmath>

#include "geometry/vec.h"

namespace foldwright {

/// Orientation-preserving rigid motion of the plane: x -> R x + t, R the rotation (c, s).
struct RigidMotion2 {
  double c = 1;
  double s = 0;
  Vec2 t = Vec2::Zero();

  Vec2 operator()(const Vec2& p) const {
    return {c * p.x() - s * p.y() + t.x(), s * p.x() + c * p.y() + t.y()};
  }

  /// Applies `b` first, then `a`. The rotation is renormalised: without that the scale error of a
  /// chain of compositions grows with its length and a long search drifts without bound.
  friend RigidMotion2 operator*(const RigidMotion2& a, const RigidMotion2& b) {
    const double c = a.c * b.c - a.s * b.s;
    const double s = a.s * b.c + a.c * b.s;
    const double scale = 1 / std::sqrt(c * c + s * s);
    return {c * scale, s * scale, a(b.t)};
  }

  RigidMotion2 inverse() const {
    return {c, -s, Vec2(-(c * t.x() + s * t.y()), s * t.x() - c * t.y())};
  }
};

/// The motion that takes segment (a, b) onto (p, q). \pre both have the same, non-zero length
inline RigidMotion2 motion_onto(const Vec2& a, const Vec2& b, const Vec2& p, const Vec2& q) {
  const Vec2 from = b - a;
  const Vec2 to = q - p;
  const double scale = 1 / std::sqrt(from.squaredNorm() * to.squaredNorm());
  const double c = from.dot(to) * scale;
  const double s = cross(from, to) * scale;
  const double unit = 1 / std::sqrt(c * c + s * s);
  RigidMotion2 motion{c * unit, s * unit, Vec2::Zero()};
  // The midpoints are matched, so a tiny difference in length is shared by both ends.
  motion.t = 0.5 * (p + q) - motion(0.5 * (a + b));
  return motion;
}

}  // namespace foldwright
