#include "geometry/box_tree.h"

#include <algorithm>
#include <numeric>

namespace foldwright {
namespace {

// Items of a leaf: looking at a few costs about as much as two more nodes.
constexpr int kLeafSize = 4;

}  // namespace

BoxTree::BoxTree(std::span<const Box3> boxes) : items_(boxes.size()) {
  std::iota(items_.begin(), items_.end(), 0);
  if (!boxes.empty()) build(boxes, 0, static_cast<int>(boxes.size()));
}

/// Adds the tree over some items, halved across the longest side of their box; returns its node.
int BoxTree::build(std::span<const Box3> boxes, int first, int last) {
  const int index = static_cast<int>(nodes_.size());
  Box3 all = boxes[items_[first]];
  for (int i = first + 1; i < last; ++i) all = all.joined(boxes[items_[i]]);
  nodes_.push_back({all, first, last, -1});
  if (last - first <= kLeafSize) return index;
  int axis = 0;
  for (const int i : {1, 2}) {
    if (all.max[i] - all.min[i] > all.max[axis] - all.min[axis]) axis = i;
  }
  const auto place = [&](int item) { return boxes[item].min[axis] + boxes[item].max[axis]; };
  const int middle = (first + last) / 2;
  std::nth_element(items_.begin() + first, items_.begin() + middle, items_.begin() + last,
                   [&](int a, int b) { return std::pair(place(a), a) < std::pair(place(b), b); });
  build(boxes, first, middle);
  const int right = build(boxes, middle, last);
  nodes_[index].right = right;
  return index;
}

double BoxTree::distance2(const Vec3& point, const Box3& box) {
  double sum = 0;
  for (int i = 0; i < 3; ++i) {
    const double off = std::max({0.0, box.min[i] - point[i], point[i] - box.max[i]});
    sum += off * off;
  }
  return sum;
}

}  // namespace foldwright
