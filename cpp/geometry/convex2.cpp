#include "geometry/convex2.h"

#include <algorithm>

namespace foldwright {
namespace {

/// Whether some edge of `a` has all of `b` on its outer side, up to a depth of `tolerance`.
bool separates(std::span<const Vec2> a, std::span<const Vec2> b, double tolerance) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Vec2 edge = a[(i + 1) % a.size()] - a[i];
    const double limit = tolerance * edge.norm();
    const bool outside = std::all_of(b.begin(), b.end(),
                                     [&](const Vec2& p) { return cross(edge, p - a[i]) <= limit; });
    if (outside && edge.squaredNorm() > 0) return true;
  }
  return false;
}

}  // namespace

Box2 box_of(std::span<const Vec2> points) {
  Box2 box{{points[0].x(), points[0].y()}, {points[0].x(), points[0].y()}};
  for (const Vec2& p : points) {
    for (const int i : {0, 1}) {
      box.min[i] = std::min(box.min[i], p[i]);
      box.max[i] = std::max(box.max[i], p[i]);
    }
  }
  return box;
}

bool convex_overlap(std::span<const Vec2> a, std::span<const Vec2> b, double tolerance) {
  return !separates(a, b, tolerance) && !separates(b, a, tolerance);
}

}  // namespace foldwright
