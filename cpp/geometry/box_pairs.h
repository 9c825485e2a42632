#pragma once

#include <array>
#include <span>
#include <vector>

#include "geometry/box.h"

namespace foldwright {

/// All pairs (i, j), i < j, of boxes whose interiors meet, each once, in a fixed order; in two or
/// three dimensions.
///
/// A uniform grid with cells of about the mean box; near-linear for boxes of similar size, and
/// never worse than the number of cells the boxes cover, which is bounded by a constant times n
/// for boxes in a layout of n faces.
template <int N>
std::vector<std::array<int, 2>> meeting_boxes(std::span<const Box<N>> boxes);

extern template std::vector<std::array<int, 2>> meeting_boxes<2>(std::span<const Box2> boxes);
extern template std::vector<std::array<int, 2>> meeting_boxes<3>(std::span<const Box3> boxes);

template <int N>
std::vector<std::array<int, 2>> meeting_boxes(const std::vector<Box<N>>& boxes) {
  return meeting_boxes<N>(std::span<const Box<N>>(boxes));
}

}  // namespace foldwright
