#include "search/hyperbolic.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "meshes.h"

namespace foldwright {
namespace {

int count(const std::vector<char>& flags) {
  return static_cast<int>(std::count(flags.begin(), flags.end(), 1));
}

TEST(Hyperbolic, ConvexSurfacesHaveNone) {
  EXPECT_EQ(count(hyperbolic_vertices(testing::cube())), 0);
  EXPECT_EQ(count(hyperbolic_vertices(testing::icosahedron())), 0);
}

TEST(Hyperbolic, AStarHasThemBetweenItsSpikes) {
  // The 12 corners of the icosahedron carry ten steep spike faces each.
  EXPECT_EQ(count(hyperbolic_vertices(testing::star())), 12);
}

TEST(Hyperbolic, FlatVerticesDoNotCount) {
  EXPECT_EQ(count(hyperbolic_vertices(testing::saddle(8, 2 * std::numbers::pi))), 0);
}

TEST(Hyperbolic, CountsOnlyVerticesInsideTheGraph) {
  const Mesh saddle = testing::saddle(8, 2.5 * std::numbers::pi);
  const DualGraph graph = build_dual_graph(saddle);
  for (const auto& vertices : hyperbolic_vertices_of_panels(saddle, graph)) {
    EXPECT_EQ(vertices, std::vector<int>{0}) << "the centre of the fan lies inside";
  }
  const DualGraph open = restrict_to(graph, std::vector<int>{0, 1, 2});
  for (const auto& vertices : hyperbolic_vertices_of_panels(saddle, open)) {
    EXPECT_TRUE(vertices.empty()) << "three of its faces leave the centre on the border";
  }
}

}  // namespace
}  // namespace foldwright
