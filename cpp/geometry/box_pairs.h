#pragma once

#include <array>
#include <functional>
#include <span>
#include <vector>

#include "geometry/box.h"

namespace foldwright {

/// All pairs (i, j), i < j, of boxes whose interiors meet, each once, in a fixed order; in two or
/// three dimensions.
///
/// Sweeps along the longest axis, in columns of some boxes' width: what is compared lies side by
/// side in memory. n log n for boxes of similar size that lie spread out; at worst, where all lie
/// at the same place along that axis, quadratic in those of a column.
template <int N>
std::vector<std::array<int, 2>> meeting_boxes(std::span<const Box<N>> boxes);

extern template std::vector<std::array<int, 2>> meeting_boxes<2>(std::span<const Box2> boxes);
extern template std::vector<std::array<int, 2>> meeting_boxes<3>(std::span<const Box3> boxes);

template <int N>
std::vector<std::array<int, 2>> meeting_boxes(const std::vector<Box<N>>& boxes) {
  return meeting_boxes<N>(std::span<const Box<N>>(boxes));
}

/// Calls `visit(i, j)` for the same pairs in the same order, until it returns false. Memory is
/// linear in the boxes, where there may be a pair of every two: in models that were damaged.
void visit_meeting_boxes(std::span<const Box3> boxes, const std::function<bool(int, int)>& visit);

}  // namespace foldwright
