#include "geometry/face_contact.h"

#include <algorithm>
#include <cmath>

namespace foldwright {
namespace {

// Faces that go into each other by less than this share of the model's extent touch: a tenth of a
// millimetre on ten centimetres is less than paper is thick.
constexpr double kDepth = 1e-3;

// Small faces touch when it is less than this share of their size.
constexpr double kShareOfFace = 0.1;

Vec3 area_vector(const Triangle3& t) { return (t[1] - t[0]).cross(t[2] - t[0]); }

/// How deep a touch of two faces may go.
double depth_of_touch(const Triangle3& a, const Triangle3& b, double extent) {
  const double smaller = std::sqrt(std::min(area_vector(a).norm(), area_vector(b).norm()));
  return std::min(kDepth * extent, kShareOfFace * smaller);
}

/// By how much the shadows of two triangles on a line overlap; negative where they are apart.
double overlap_along(const Vec3& direction, const Triangle3& a, const Triangle3& b) {
  const auto shadow = [&](const Triangle3& t) {
    return std::minmax({direction.dot(t[0]), direction.dot(t[1]), direction.dot(t[2])});
  };
  const auto [first_a, last_a] = shadow(a);
  const auto [first_b, last_b] = shadow(b);
  return std::min(last_a, last_b) - std::max(first_a, first_b);
}

bool lies_in_plane(const Triangle3& t, const Vec3& point, const Vec3& normal, double depth) {
  return std::ranges::all_of(
      t, [&](const Vec3& corner) { return std::abs(normal.dot(corner - point)) <= depth; });
}

}  // namespace

bool faces_cross(const Triangle3& a, const Triangle3& b, double extent) {
  return triangles_cross(a, b, depth_of_touch(a, b, extent));
}

bool faces_overlap(const Triangle3& a, const Triangle3& b, double extent) {
  const double depth = depth_of_touch(a, b, extent);
  const Vec3 normal = area_vector(a).normalized();
  if (!lies_in_plane(b, a[0], normal, depth)) return false;
  // In a plane the normals of the edges are all axes that can tell triangles apart.
  for (const Triangle3& t : {a, b}) {
    for (int i = 0; i < 3; ++i) {
      const Vec3 across = normal.cross(t[(i + 1) % 3] - t[i]).normalized();
      if (overlap_along(across, a, b) <= depth) return false;
    }
  }
  return true;
}

}  // namespace foldwright
