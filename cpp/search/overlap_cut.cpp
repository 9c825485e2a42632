#include "search/overlap_cut.h"

#include <algorithm>
#include <ranges>
#include <tuple>

#include "unfold/layout.h"

namespace foldwright {
namespace {

/// Per panel the number of folds from it up to the root.
std::vector<int> depths_of(const RootedTree& tree) {
  std::vector<int> depths(tree.parent.size(), 0);
  for (const int panel : tree.order) {
    if (tree.parent[panel] != -1) depths[panel] = depths[tree.parent[panel]] + 1;
  }
  return depths;
}

/// Per panel the number of overlapping pairs that its fold to its parent lies between.
std::vector<int> pairs_parted(const DualGraph& graph, const RootedTree& tree) {
  const std::vector<int> depths = depths_of(tree);
  std::vector<int> pairs(tree.parent.size(), 0);
  for (auto [a, b] : overlapping_panels(graph, lay_out(graph, tree))) {
    while (a != b) {
      int& lower = depths[a] >= depths[b] ? a : b;
      ++pairs[lower];
      lower = tree.parent[lower];
    }
  }
  return pairs;
}

/// Per panel the number of panels at or below it.
std::vector<int> sizes_of(const RootedTree& tree) {
  std::vector<int> sizes(tree.parent.size(), 1);
  for (const int panel : tree.order | std::views::reverse) {
    if (tree.parent[panel] != -1) sizes[tree.parent[panel]] += sizes[panel];
  }
  return sizes;
}

}  // namespace

int best_overlap_cut(const DualGraph& graph, const FoldTree& folds) {
  const RootedTree tree = hang_tree(graph, folds);
  const std::vector<int> pairs = pairs_parted(graph, tree);
  const std::vector<int> sizes = sizes_of(tree);
  std::tuple<int, int, int> best{-1, 0, 0};  // pairs parted, panels of the smaller half, panel
  for (const int panel : tree.order) {
    if (tree.parent[panel] == -1 || graph.hinges[tree.hinge[panel]].stays_fold) continue;
    const int smaller = std::min(sizes[panel], graph.panel_count() - sizes[panel]);
    best = std::max(best, {pairs[panel], smaller, panel});
  }
  const int cut = tree.hinge[std::get<2>(best)];
  return static_cast<int>(std::ranges::find(folds, cut) - folds.begin());
}

}  // namespace foldwright
