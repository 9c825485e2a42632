#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

namespace foldwright {

/// Disjoint sets of the integers below some size. Its lowest member stands for a set, so that the
/// outcome does not depend on the order of the joins. Nearly constant time per call.
class UnionFind {
 public:
  explicit UnionFind(int size) : leader_(size) { std::iota(leader_.begin(), leader_.end(), 0); }

  /// The lowest member of the item's set.
  int find(int item) {
    while (leader_[item] != item) item = leader_[item] = leader_[leader_[item]];
    return item;
  }

  /// Joins the sets of two items; false if they were one already.
  bool join(int a, int b) {
    a = find(a);
    b = find(b);
    leader_[std::max(a, b)] = std::min(a, b);
    return a != b;
  }

 private:
  std::vector<int> leader_;
};

}  // namespace foldwright
