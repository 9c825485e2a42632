#include "mesh/looks.h"

#include <cmath>

namespace foldwright {
namespace {

/// The mean of what the three corners have, and where the corner is one of them, just that: what a
/// mean has from a corner without weight may be no number.
template <class Value, class Mean>
Value value_at(const std::vector<Value>& values, int first, const CornerOrigin& origin,
               Mean&& mean) {
  for (int i = 0; i < 3; ++i) {
    if (origin.weights[i] == 1) return values[first + origin.corners[i]];
  }
  return mean(values[first + origin.corners[0]], values[first + origin.corners[1]],
              values[first + origin.corners[2]], origin.weights);
}

PicturePlace mean_place(const PicturePlace& a, const PicturePlace& b, const PicturePlace& c,
                        const Vec3& weights) {
  PicturePlace mean;
  for (std::size_t k = 0; k < mean.size(); ++k) {
    mean[k] = static_cast<float>(weights.dot(Vec3(a[k], b[k], c[k])));
  }
  return mean;
}

Rgb mean_colour(const Rgb& a, const Rgb& b, const Rgb& c, const Vec3& weights) {
  Rgb mean;
  for (std::size_t k = 0; k < mean.size(); ++k) {
    mean[k] = static_cast<std::uint8_t>(std::lround(weights.dot(Vec3(a[k], b[k], c[k]))));
  }
  return mean;
}

}  // namespace

FaceLooks carry_looks(const FaceLooks& looks, std::span<const int> first_corner,
                      std::span<const FaceOrigins> origins) {
  FaceLooks carried;
  for (const FaceOrigins& face : origins) {
    for (const CornerOrigin& corner : face) {
      const int first = first_corner[corner.face];
      if (!looks.places.empty()) {
        carried.places.push_back(value_at(looks.places, first, corner, mean_place));
      }
      if (!looks.colours.empty()) {
        carried.colours.push_back(value_at(looks.colours, first, corner, mean_colour));
      }
    }
    if (!looks.materials.empty()) carried.materials.push_back(looks.materials[face[0].face]);
  }
  return carried;
}

}  // namespace foldwright
