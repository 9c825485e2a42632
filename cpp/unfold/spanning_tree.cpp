#include "unfold/spanning_tree.h"

#include <algorithm>
#include <cassert>
#include <numeric>

#include "geometry/union_find.h"

namespace foldwright {

FoldTree minimum_spanning_tree(const DualGraph& graph, std::span<const double> weights) {
  assert(static_cast<int>(weights.size()) == graph.hinge_count());
  std::vector<int> by_weight(graph.hinge_count());
  std::iota(by_weight.begin(), by_weight.end(), 0);
  std::sort(by_weight.begin(), by_weight.end(), [&](int a, int b) {
    const bool a_stays = graph.hinges[a].stays_fold;
    const bool b_stays = graph.hinges[b].stays_fold;
    if (a_stays != b_stays) return a_stays;
    return weights[a] != weights[b] ? weights[a] < weights[b] : a < b;
  });
  UnionFind trees(graph.panel_count());
  FoldTree folds;
  folds.reserve(graph.panel_count() - 1);
  for (const int h : by_weight) {
    const auto& [a, b] = graph.hinges[h].panels;
    if (trees.join(a, b)) folds.push_back(h);
  }
  assert(static_cast<int>(folds.size()) == graph.panel_count() - 1 && "graph is not connected");
  std::sort(folds.begin(), folds.end());
  return folds;
}

RootedTree hang_tree(const DualGraph& graph, std::span<const int> folds, int root) {
  const int n = graph.panel_count();
  std::vector<char> is_fold(graph.hinge_count(), 0);
  for (const int h : folds) is_fold[h] = 1;
  RootedTree tree{{root}, std::vector<int>(n, -1), std::vector<int>(n, -1)};
  tree.order.reserve(n);
  for (std::size_t head = 0; head < tree.order.size(); ++head) {
    const int panel = tree.order[head];
    for (const int h : graph.hinges_of(panel)) {
      if (!is_fold[h] || h == tree.hinge[panel]) continue;
      const int child = graph.hinges[h].other(panel);
      tree.parent[child] = panel;
      tree.hinge[child] = h;
      tree.order.push_back(child);
    }
  }
  assert(static_cast<int>(tree.order.size()) == n && "folds do not span the graph");
  return tree;
}

int tree_centre(const DualGraph& graph, std::span<const int> folds) {
  // The middle of a longest path, whose ends two breadth-first searches find.
  const RootedTree from_any = hang_tree(graph, folds);
  const RootedTree from_end = hang_tree(graph, folds, from_any.order.back());
  std::vector<int> path;
  for (int panel = from_end.order.back(); panel != -1; panel = from_end.parent[panel]) {
    path.push_back(panel);
  }
  const std::size_t middle = path.size() / 2;
  return path.size() % 2 == 1 ? path[middle] : std::min(path[middle - 1], path[middle]);
}

}  // namespace foldwright
