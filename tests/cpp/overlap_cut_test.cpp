#include "search/overlap_cut.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "meshes.h"
#include "trees.h"
#include "unfold/layout.h"

namespace foldwright::testing {
namespace {

/// Per panel whether it hangs below a fold.
std::vector<char> panels_below(const RootedTree& tree, int fold) {
  std::vector<char> below(tree.parent.size(), 0);
  for (const int panel : tree.order) {
    if (tree.parent[panel] == -1) continue;
    below[panel] = tree.hinge[panel] == fold || below[tree.parent[panel]];
  }
  return below;
}

TEST(BestOverlapCut, PartsTheEndsOfASaddleInTheMiddle) {
  // A fan of more than a full turn: cut open once, its first and last faces overlap, whichever
  // fold between them is cut.
  const Mesh mesh = saddle(8, 7);
  const DualGraph graph = build_dual_graph(mesh);
  FoldTree folds(graph.hinge_count());
  std::iota(folds.begin(), folds.end(), 0);
  folds.pop_back();
  const RootedTree tree = hang_tree(graph, folds);
  ASSERT_FALSE(overlapping_panels(graph, lay_out(graph, tree)).empty());
  const std::vector<char> below = panels_below(tree, folds[best_overlap_cut(graph, folds)]);
  EXPECT_EQ(std::accumulate(below.begin(), below.end(), 0), 4);
}

TEST(BestOverlapCut, PartsAsManyPairsAsAnyFoldCan) {
  const Mesh mesh = dumbbell();
  const DualGraph graph = build_dual_graph(mesh);
  for (const std::uint64_t seed : {1, 2, 3}) {
    Random random(seed);
    std::vector<double> weights(graph.hinge_count());
    for (double& weight : weights) weight = random.uniform();
    const FoldTree folds = minimum_spanning_tree(graph, weights);
    const RootedTree tree = hang_tree(graph, folds);
    const auto overlaps = overlapping_panels(graph, lay_out(graph, tree));
    ASSERT_GT(overlaps.size(), 10u);
    // Counted the slow way, fold by fold.
    const auto parted = [&](int fold) {
      const std::vector<char> below = panels_below(tree, folds[fold]);
      return std::ranges::count_if(
          overlaps, [&](const auto& pair) { return below[pair[0]] != below[pair[1]]; });
    };
    const auto found = parted(best_overlap_cut(graph, folds));
    for (int fold = 0; fold < static_cast<int>(folds.size()); ++fold) {
      EXPECT_LE(parted(fold), found);
    }
  }
}

}  // namespace
}  // namespace foldwright::testing
