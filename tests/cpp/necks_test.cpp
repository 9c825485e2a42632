#include "paper/necks.h"

#include <gtest/gtest.h>

#include "meshes.h"
#include "unfold/spanning_tree.h"

namespace foldwright::testing {
namespace {

std::vector<int> necks_of(const DualGraph& graph, double scale) {
  // The graph of a strip is a chain: all its hinges are folds.
  const std::vector<char> all(graph.hinge_count(), 1);
  return find_necks(graph, all, scale);
}

TEST(FindNecks, NamesShortFoldsBetweenManyFaces) {
  // Panels of two triangles in a row, joined by folds of length 1.
  const DualGraph graph = build_dual_graph(accordion(std::vector<double>(12, 3)));
  ASSERT_EQ(graph.hinge_count(), 11);
  // Four panels, of eight faces, on either side at least.
  EXPECT_EQ(necks_of(graph, 4.9), (std::vector<int>{3, 4, 5, 6, 7}));
}

TEST(FindNecks, LeavesFoldsThatHold) {
  const DualGraph graph = build_dual_graph(accordion(std::vector<double>(12, 3)));
  EXPECT_TRUE(necks_of(graph, 5.1).empty());
  EXPECT_TRUE(necks_of(build_dual_graph(accordion({1, 1, 1, 1})), 1).empty());
}

TEST(FindNecks, LooksAtTheFoldsOfTheTreeOnly) {
  const DualGraph graph = build_dual_graph(bumpy_sphere(100));
  const std::vector<double> weights(graph.hinge_count(), 0);
  const FoldTree folds = minimum_spanning_tree(graph, weights);
  std::vector<char> is_fold(graph.hinge_count(), 0);
  for (const int h : folds) is_fold[h] = 1;
  const std::vector<int> necks = find_necks(graph, is_fold, 1);
  EXPECT_FALSE(necks.empty());
  for (const int h : necks) EXPECT_TRUE(is_fold[h]);
}

}  // namespace
}  // namespace foldwright::testing
