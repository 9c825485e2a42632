#include "unfold/spanning_tree.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "drawn_shapes.h"
#include "meshes.h"
#include "trees.h"

namespace foldwright::testing {
namespace {

double weight_of(const FoldTree& folds, const std::vector<double>& weights) {
  double sum = 0;
  for (const int h : folds) sum += weights[h];
  return sum;
}

TEST(MinimumSpanningTree, IsTheLightestOfAllTrees) {
  for (const Mesh& mesh : {tetrahedron(), cube(), saddle(8, 7), two_sided_square()}) {
    const DualGraph graph = build_dual_graph(mesh);
    const std::vector<FoldTree> trees = all_spanning_trees(graph);
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      SCOPED_TRACE(seed);
      Random random(seed);
      std::vector<double> weights;
      for (int h = 0; h < graph.hinge_count(); ++h) weights.push_back(random.uniform() - 0.5);
      const auto lightest = std::ranges::min_element(
          trees, {}, [&](const FoldTree& tree) { return weight_of(tree, weights); });
      EXPECT_EQ(minimum_spanning_tree(graph, weights), *lightest);
    }
  }
}

TEST(MinimumSpanningTree, GivesTiesToTheLowerHinge) {
  for (const Mesh& mesh : {tetrahedron(), cube(), saddle(8, 7)}) {
    const DualGraph graph = build_dual_graph(mesh);
    const std::vector<double> equal(graph.hinge_count(), 0.5);
    // Taken greedily, the lowest hinges are the first tree in lexicographic order.
    EXPECT_EQ(minimum_spanning_tree(graph, equal), all_spanning_trees(graph).front());
  }
}

TEST(MinimumSpanningTree, OfOnePanelIsEmpty) {
  EXPECT_TRUE(minimum_spanning_tree(build_dual_graph(open_strip(3)), {}).empty());
}

TEST(AllSpanningTrees, AreAsManyAsKirchhoffSays) {
  EXPECT_EQ(all_spanning_trees(build_dual_graph(tetrahedron())).size(), 16u);  // of K4
  EXPECT_EQ(all_spanning_trees(build_dual_graph(cube())).size(), 384u);        // of an octahedron
  EXPECT_EQ(all_spanning_trees(build_dual_graph(saddle(8, 7))).size(), 8u);    // of a circle
}

TEST(HangTree, OrdersPanelsBreadthFirstBelowTheirParents) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    const DualGraph graph = build_dual_graph(random_hull(seed, 60));
    Random random(seed);
    const FoldTree folds = random_tree(graph, random);
    const int root = random.below(graph.panel_count());
    const RootedTree tree = hang_tree(graph, folds, root);
    ASSERT_EQ(tree.order.front(), root);
    EXPECT_EQ(tree.parent[root], -1);
    EXPECT_EQ(tree.hinge[root], -1);
    std::vector<int> depth(graph.panel_count(), -1);
    depth[root] = 0;
    FoldTree used;
    for (std::size_t i = 1; i < tree.order.size(); ++i) {
      const int panel = tree.order[i];
      ASSERT_EQ(depth[panel], -1) << "panel " << panel << " comes twice";
      ASSERT_NE(depth[tree.parent[panel]], -1) << "panel " << panel << " before its parent";
      depth[panel] = depth[tree.parent[panel]] + 1;
      EXPECT_GE(depth[panel], depth[tree.order[i - 1]]);
      EXPECT_EQ(graph.hinges[tree.hinge[panel]].other(panel), tree.parent[panel]);
      used.push_back(tree.hinge[panel]);
    }
    std::ranges::sort(used);
    EXPECT_EQ(used, folds);
  }
}

/// Folds between the root and the panel farthest from it.
int height(const DualGraph& graph, const FoldTree& folds, int root) {
  const RootedTree tree = hang_tree(graph, folds, root);
  std::vector<int> depth(graph.panel_count(), 0);
  int most = 0;
  for (std::size_t i = 1; i < tree.order.size(); ++i) {
    const int panel = tree.order[i];
    depth[panel] = depth[tree.parent[panel]] + 1;
    most = std::max(most, depth[panel]);
  }
  return most;
}

TEST(TreeCentre, IsTheLowestPanelWithTheLeastHeightBelowIt) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    for (const Mesh& mesh : {random_hull(seed, 30), l_prism(), torus(5, 4)}) {
      const DualGraph graph = build_dual_graph(mesh);
      const FoldTree folds = random_tree(graph, random);
      std::vector<int> heights;
      for (int root = 0; root < graph.panel_count(); ++root) {
        heights.push_back(height(graph, folds, root));
      }
      const auto least = std::ranges::min_element(heights);
      EXPECT_EQ(tree_centre(graph, folds), least - heights.begin());
    }
  }
}

TEST(TreeCentre, OfARowIsItsMiddle) {
  for (int panels = 1; panels <= 8; ++panels) {
    const DualGraph row = build_dual_graph(accordion(std::vector<double>(panels, 1)));
    FoldTree all;
    for (int h = 0; h < row.hinge_count(); ++h) all.push_back(h);
    EXPECT_EQ(tree_centre(row, all), (panels - 1) / 2);
  }
}

}  // namespace
}  // namespace foldwright::testing
