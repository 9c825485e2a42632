#include "mesh/looks.h"

#include <cmath>

namespace foldwright {
namespace {

/// The mean of one of the numbers that the corners of a place have. Those without weight are left
/// out: what they have may be no number.
template <class Value>
double mean_of(const std::vector<Value>& values, int first, const CornerOrigin& origin,
               std::size_t number) {
  double mean = 0;
  for (int i = 0; i < 3; ++i) {
    const double weight = origin.weights[i];
    if (weight > 0) mean += weight * values[first + origin.corners[i]][number];
  }
  return mean;
}

PicturePlace place_at(const FaceLooks& looks, int first, const CornerOrigin& origin) {
  const auto mean = [&](std::size_t axis) {
    return static_cast<float>(mean_of(looks.places, first, origin, axis));
  };
  return {mean(0), mean(1)};
}

Rgb colour_at(const FaceLooks& looks, int first, const CornerOrigin& origin) {
  const auto mean = [&](std::size_t part) {
    return static_cast<std::uint8_t>(std::lround(mean_of(looks.colours, first, origin, part)));
  };
  return {mean(0), mean(1), mean(2)};
}

}  // namespace

FaceLooks carry_looks(const FaceLooks& looks, std::span<const int> first_corner,
                      std::span<const FaceOrigins> origins) {
  FaceLooks carried;
  for (const FaceOrigins& face : origins) {
    for (const CornerOrigin& corner : face) {
      const int first = first_corner[corner.face];
      if (!looks.places.empty()) carried.places.push_back(place_at(looks, first, corner));
      if (!looks.colours.empty()) carried.colours.push_back(colour_at(looks, first, corner));
    }
    if (!looks.materials.empty()) carried.materials.push_back(looks.materials[face[0].face]);
  }
  return carried;
}

}  // namespace foldwright
