#include "paper/gluing_order.h"

#include <gtest/gtest.h>

#include "meshes.h"

namespace foldwright::testing {
namespace {

/// A net of one panel each, of an accordion of these widths.
std::vector<Net> panels_of(const std::vector<double>& widths) {
  const Mesh mesh = accordion(widths);
  const DualGraph graph = build_dual_graph(mesh);
  std::vector<Net> nets;
  for (int panel = 0; panel < graph.panel_count(); ++panel) {
    nets.push_back(make_net(mesh, restrict_to(graph, std::array{panel}), {}));
  }
  return nets;
}

TEST(GluingOrder, BeginsWithTheLargestAndGoesOnAtItsBorder) {
  // Beside the widest there are two: both borders are as long, so that the larger is next.
  EXPECT_EQ(gluing_order(panels_of({1, 2, 5, 3, 4})), (std::vector<int>{2, 3, 4, 1, 0}));
}

TEST(GluingOrder, OfNothingIsNothing) { EXPECT_TRUE(gluing_order({}).empty()); }

}  // namespace
}  // namespace foldwright::testing
