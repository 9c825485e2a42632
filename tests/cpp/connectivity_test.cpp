#include "mesh/connectivity.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "meshes.h"

namespace foldwright::testing {
namespace {

TEST(IsConnected, TellsOneGraphFromTwo) {
  const DualGraph graph = build_dual_graph(cube());
  EXPECT_TRUE(is_connected(graph));
  EXPECT_FALSE(is_connected(DualGraph{}));
  for (int panel = 1; panel < 6; ++panel) {
    const DualGraph two = restrict_to(graph, std::array{0, panel});
    EXPECT_EQ(is_connected(two), two.hinge_count() > 0);
  }
}

TEST(StaysConnected, IsFalseForTheMiddleOfARowAlone) {
  const DualGraph graph = build_dual_graph(accordion({1, 1, 1, 1, 1}));
  ASSERT_EQ(graph.panel_count(), 5);
  const std::vector<int> one_part(5, 0);
  for (int panel = 0; panel < 5; ++panel) {
    EXPECT_EQ(stays_connected(graph, one_part, panel), panel == 0 || panel == 4);
  }
  const std::vector<int> two_parts = {0, 0, 1, 0, 0};
  EXPECT_FALSE(stays_connected(graph, two_parts, 2)) << "nothing would be left";
}

}  // namespace
}  // namespace foldwright::testing
