#pragma once

#include <array>

namespace foldwright {

/// Axis-aligned box in N dimensions.
template <int N>
struct Box {
  std::array<double, N> min, max;

  /// Whether the interiors meet.
  bool meets(const Box& other) const {
    for (int i = 0; i < N; ++i) {
      if (min[i] >= other.max[i] || other.min[i] >= max[i]) return false;
    }
    return true;
  }

  /// The box with every side moved outwards.
  Box grown(double by) const {
    Box box = *this;
    for (int i = 0; i < N; ++i) {
      box.min[i] -= by;
      box.max[i] += by;
    }
    return box;
  }
};

using Box2 = Box<2>;
using Box3 = Box<3>;

}  // namespace foldwright
