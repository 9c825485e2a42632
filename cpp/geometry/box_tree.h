#pragma once

#include <span>
#include <utility>
#include <vector>

#include "geometry/box.h"
#include "geometry/vec.h"

namespace foldwright {

/// A tree over boxes that stand still, for queries by distance.
class BoxTree {
 public:
  /// n log n.
  explicit BoxTree(std::span<const Box3> boxes);

  /// Looks for the item nearest to a point, whatever makes it near: calls `visit(item)`, which
  /// returns the square of the distance within which boxes are still of interest, for every item
  /// whose box is that near, in no particular order. `within`: that square at the start.
  template <class Visit>
  void visit_near(const Vec3& point, double within, Visit&& visit) const {
    if (nodes_.empty()) return;
    std::vector<std::pair<double, int>> open = {{distance2(point, nodes_[0].box), 0}};
    while (!open.empty()) {
      const auto [distance, index] = open.back();
      open.pop_back();
      if (distance > within) continue;
      const Node& node = nodes_[index];
      if (node.right == -1) {
        for (int i = node.first; i < node.last; ++i) within = visit(items_[i]);
        continue;
      }
      std::pair<double, int> near = {distance2(point, nodes_[index + 1].box), index + 1};
      std::pair<double, int> far = {distance2(point, nodes_[node.right].box), node.right};
      if (near > far) std::swap(near, far);
      open.push_back(far);
      open.push_back(near);
    }
  }

 private:
  struct Node {
    Box3 box;
    int first, last;  ///< items below it
    int right;        ///< second child, the first one follows its parent; -1: a leaf
  };

  static double distance2(const Vec3& point, const Box3& box);
  int build(std::span<const Box3> boxes, int first, int last);

  std::vector<int> items_;
  std::vector<Node> nodes_;
};

}  // namespace foldwright
