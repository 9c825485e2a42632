#pragma once

#include <algorithm>
#include <array>
#include <cmath>

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

  double diagonal() const {
    double sum = 0;
    for (int i = 0; i < N; ++i) sum += (max[i] - min[i]) * (max[i] - min[i]);
    return std::sqrt(sum);
  }

  /// The smallest box around both.
  Box joined(const Box& other) const {
    Box box = *this;
    for (int i = 0; i < N; ++i) {
      box.min[i] = std::min(box.min[i], other.min[i]);
      box.max[i] = std::max(box.max[i], other.max[i]);
    }
    return box;
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
