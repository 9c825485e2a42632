#include "geometry/triangle2.h"

#include <cmath>

namespace foldwright {
namespace {

/// Whether an edge of `a` separates: all of `b` lies at most `tolerance` inside of it.
bool edge_separates(const Triangle2& a, const Triangle2& b, double tolerance) {
  for (int i = 0; i < 3; ++i) {
    const Vec2& origin = a[i];
    const Vec2 edge = a[(i + 1) % 3] - origin;
    const double depth = std::max(
        {cross(edge, b[0] - origin), cross(edge, b[1] - origin), cross(edge, b[2] - origin)});
    // Squares instead of a root: depth / |edge| <= tolerance.
    if (depth <= 0 || depth * depth <= tolerance * tolerance * edge.squaredNorm()) return true;
  }
  return false;
}

}  // namespace

bool triangles_overlap(const Triangle2& a, const Triangle2& b, double tolerance) {
  return !edge_separates(a, b, tolerance) && !edge_separates(b, a, tolerance);
}

double intersection_area(const Triangle2& a, const Triangle2& b) {
  // Each of the three cuts adds at most one corner to the three there are.
  std::array<Vec2, 8> polygon = {b[0], b[1], b[2]};
  int count = 3;
  for (int i = 0; i < 3 && count > 0; ++i) {
    const Vec2 edge = a[(i + 1) % 3] - a[i];
    std::array<Vec2, 8> clipped;
    int kept = 0;
    for (int k = 0; k < count; ++k) {
      const Vec2& p = polygon[k];
      const Vec2& q = polygon[(k + 1) % count];
      const double side_p = cross(edge, p - a[i]);
      const double side_q = cross(edge, q - a[i]);
      if (side_p >= 0) clipped[kept++] = p;
      if ((side_p > 0 && side_q < 0) || (side_p < 0 && side_q > 0)) {
        clipped[kept++] = p + (side_p / (side_p - side_q)) * (q - p);
      }
    }
    polygon = clipped;
    count = kept;
  }
  double twice_area = 0;
  for (int k = 2; k < count; ++k) {
    twice_area += cross(polygon[k - 1] - polygon[0], polygon[k] - polygon[0]);
  }
  return 0.5 * std::abs(twice_area);
}

}  // namespace foldwright
