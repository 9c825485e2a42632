#include "geometry/triangle3.h"

#include <algorithm>

namespace foldwright {
namespace {

/// Gap between the projections on an axis, in units of its length; negative when they meet.
double gap_along(const Vec3& axis, const Triangle3& a, const Triangle3& b) {
  // Relative to a corner, which keeps the rounding small far from the origin.
  const double a1 = axis.dot(a[1] - a[0]);
  const double a2 = axis.dot(a[2] - a[0]);
  const double b0 = axis.dot(b[0] - a[0]);
  const double b1 = axis.dot(b[1] - a[0]);
  const double b2 = axis.dot(b[2] - a[0]);
  const double low_a = std::min({0.0, a1, a2});
  const double high_a = std::max({0.0, a1, a2});
  const double low_b = std::min({b0, b1, b2});
  const double high_b = std::max({b0, b1, b2});
  return std::max(low_b - high_a, low_a - high_b);
}

Vec3 closest_on_segment(const Vec3& a, const Vec3& b, const Vec3& p) {
  const Vec3 along = b - a;
  const double length2 = along.squaredNorm();
  return length2 > 0 ? Vec3(a + std::clamp((p - a).dot(along) / length2, 0.0, 1.0) * along) : a;
}

}  // namespace

Box3 box_of(const Triangle3& t) {
  Box3 box;
  for (int i = 0; i < 3; ++i) {
    box.min[i] = std::min({t[0][i], t[1][i], t[2][i]});
    box.max[i] = std::max({t[0][i], t[1][i], t[2][i]});
  }
  return box;
}

Vec3 closest_point(const Triangle3& t, const Vec3& p) {
  const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
  const double area2 = normal.squaredNorm();
  bool above = area2 > 0;
  for (int i = 0; i < 3 && above; ++i) {
    above = normal.dot((t[(i + 1) % 3] - t[i]).cross(p - t[i])) >= 0;
  }
  if (above) return p - normal * (normal.dot(p - t[0]) / area2);
  Vec3 best = closest_on_segment(t[0], t[1], p);
  for (int i = 1; i < 3; ++i) {
    const Vec3 other = closest_on_segment(t[i], t[(i + 1) % 3], p);
    if ((other - p).squaredNorm() < (best - p).squaredNorm()) best = other;
  }
  return best;
}

Vec3 barycentric(const Triangle3& t, const Vec3& p) {
  const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
  const double area2 = normal.squaredNorm();
  const double at_1 = normal.dot((p - t[0]).cross(t[2] - t[0])) / area2;
  const double at_2 = normal.dot((t[1] - t[0]).cross(p - t[0])) / area2;
  return {1 - at_1 - at_2, at_1, at_2};
}

Triangle3 moved(const RigidMotion3& motion, const Triangle2& t) {
  const Eigen::Matrix3d r = motion.r.toRotationMatrix();
  const auto place = [&](const Vec2& p) -> Vec3 {
    return r.col(0) * p.x() + r.col(1) * p.y() + motion.t;
  };
  return {place(t[0]), place(t[1]), place(t[2])};
}

Triangle3 moved(const RigidMotion3& motion, const Triangle3& t) {
  const Eigen::Matrix3d r = motion.r.toRotationMatrix();
  return {r * t[0] + motion.t, r * t[1] + motion.t, r * t[2] + motion.t};
}

Triangle2 eroded(const Triangle2& t, double depth, double least) {
  const std::array<double, 3> opposite = {(t[2] - t[1]).norm(), (t[0] - t[2]).norm(),
                                          (t[1] - t[0]).norm()};
  const double perimeter = opposite[0] + opposite[1] + opposite[2];
  const Vec2 incentre = (opposite[0] * t[0] + opposite[1] * t[1] + opposite[2] * t[2]) / perimeter;
  const double inradius = std::abs(cross(t[1] - t[0], t[2] - t[0])) / perimeter;
  const double scale = std::max(least, 1 - depth / inradius);
  Triangle2 smaller;
  for (int i = 0; i < 3; ++i) smaller[i] = incentre + scale * (t[i] - incentre);
  return smaller;
}

bool triangles_meet(const Triangle3& a, const Triangle3& b, double tolerance) {
  bool apart = false;
  for_separating_axes(a, b, [&](const Vec3& axis) {
    const double gap = gap_along(axis, a, b);
    // Squares instead of a root: gap / |axis| > tolerance.
    return apart = gap > 0 && gap * gap > tolerance * tolerance * axis.squaredNorm();
  });
  return !apart;
}

bool triangles_cross(const Triangle3& a, const Triangle3& b, double depth) {
  const double longest = std::max({(a[1] - a[0]).squaredNorm(), (a[2] - a[1]).squaredNorm(),
                                   (a[0] - a[2]).squaredNorm(), (b[1] - b[0]).squaredNorm(),
                                   (b[2] - b[1]).squaredNorm(), (b[0] - b[2]).squaredNorm()});
  // Cross products of parallel edges: their direction is rounding.
  constexpr double kParallel = 1e-9;
  bool apart = false;
  for_separating_axes(a, b, [&](const Vec3& axis) {
    if (axis.squaredNorm() <= kParallel * kParallel * longest * longest) return false;
    return apart = gap_along(axis, a, b) > -depth * axis.norm();
  });
  return !apart;
}

}  // namespace foldwright
