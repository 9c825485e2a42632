#include "mesh/corner_origin.h"

#include <cassert>

#include "mesh/polygon_soup.h"

namespace foldwright {
namespace {

/// The same corners with other weights. Rounding is taken out of them.
CornerOrigin with_weights(const CornerOrigin& like, const Vec3& weights) {
  const Vec3 positive = weights.cwiseMax(0);
  return {like.face, like.corners, positive / positive.sum()};
}

[[maybe_unused]] bool share_corners(const CornerOrigin& a, const CornerOrigin& b) {
  return a.face == b.face && a.corners == b.corners;
}

}  // namespace

FaceOrigins origins_of_triangle(int face, const std::array<int, 3>& corners) {
  return {{{face, corners, Vec3::UnitX()},
           {face, corners, Vec3::UnitY()},
           {face, corners, Vec3::UnitZ()}}};
}

CornerOrigin place_between(const CornerOrigin& from, const CornerOrigin& to, double share) {
  assert(share_corners(from, to) && share >= 0 && share <= 1);
  return with_weights(from, (1 - share) * from.weights + share * to.weights);
}

CornerOrigin place_within(const FaceOrigins& triangle, const Vec3& coordinates) {
  const auto& [a, b, c] = triangle;
  assert(share_corners(a, b) && share_corners(b, c));
  return with_weights(
      a, coordinates.x() * a.weights + coordinates.y() * b.weights + coordinates.z() * c.weights);
}

Vec3 position_at(const PolygonSoup& soup, const CornerOrigin& origin) {
  Vec3 sum = Vec3::Zero();
  for (int i = 0; i < 3; ++i) {
    const int corner = soup.first_corner[origin.face] + origin.corners[i];
    sum += origin.weights[i] * soup.positions[soup.corners[corner]];
  }
  return sum;
}

}  // namespace foldwright
