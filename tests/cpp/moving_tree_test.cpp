#include "search/moving_tree.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "meshes.h"
#include "trees.h"

namespace foldwright::testing {
namespace {

/// Folds between two panels of a tree.
int distance(MovingTree& tree, int a, int b) {
  std::vector<int> path;
  tree.path(a, b, path);
  return static_cast<int>(path.size());
}

TEST(MovingTree, OffersNoFoldThatIsNeverToBeCut) {
  DualGraph graph = build_dual_graph(torus(12, 8));
  Random random(1);
  const FoldTree folds = random_tree(graph, random);
  MovingTree free(graph, folds);
  std::vector<int> all;
  free.path(0, graph.panel_count() - 1, all);
  ASSERT_GT(all.size(), 2u);
  graph.hinges[all[1]].stays_fold = true;
  MovingTree tree(graph, folds);
  std::vector<int> path;
  tree.path(0, graph.panel_count() - 1, path);
  all.erase(all.begin() + 1);
  EXPECT_EQ(path, all);
}

TEST(MovingTree, ListsTheSideThatMovesFromTheJoinOn) {
  const DualGraph graph = build_dual_graph(torus(12, 8));
  Random random(1);
  const FoldTree folds = random_tree(graph, random);
  MovingTree tree(graph, folds);
  for (const int cut : folds) {
    tree.select_side(cut);
    if (tree.joins().empty()) continue;
    const int join = tree.joins()[random.below(static_cast<int>(tree.joins().size()))];
    const int hung = tree.ends(join).hung;
    tree.list_from(join);
    std::vector<int> listed;
    std::vector<int> distances;
    for (std::size_t i = 0; i < tree.selected().size(); ++i) {
      listed.push_back(tree.listed(i));
      distances.push_back(distance(tree, hung, listed.back()));
    }
    EXPECT_EQ(listed[0], hung);
    EXPECT_TRUE(std::ranges::is_sorted(distances)) << "nearer ones come first";
    EXPECT_TRUE(std::ranges::is_permutation(listed, tree.selected()));
  }
}

}  // namespace
}  // namespace foldwright::testing
