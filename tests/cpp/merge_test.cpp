#include "segment/merge.h"

#include <gtest/gtest.h>

#include "meshes.h"
#include "parts.h"

namespace foldwright::testing {
namespace {

TEST(MergeClusters, MakesConnectedPartsAsManyAsAsked) {
  for (const Mesh& mesh : {star(), torus(12, 8), l_prism(), accordion({1, 2, 1, 2, 1})}) {
    const Unfoldable surface = unfoldable(mesh);
    const FoldabilityMatrix matrix = learn(surface, 50);
    const int n = surface.graph.panel_count();
    for (const int parts : {1, 2, 3, n / 2, n - 1, n}) {
      SCOPED_TRACE(parts);
      const Labels labels = merge_clusters(surface.mesh, surface.graph, matrix, {.parts = parts});
      EXPECT_EQ(part_count(labels), parts);
      EXPECT_EQ(fault_of_parts(surface.graph, labels), "");
    }
  }
}

TEST(MergeClusters, FindsTheTwoBallsOfADumbbell) {
  const Unfoldable surface = unfoldable(dumbbell());
  const FoldabilityMatrix matrix = learn(surface, 100);
  for (const int parts : {0, 2}) {
    SCOPED_TRACE(parts);
    const Labels labels = merge_clusters(surface.mesh, surface.graph, matrix, {.parts = parts});
    ASSERT_EQ(part_count(labels), 2);
    EXPECT_EQ(fault_of_parts(surface.graph, labels), "");
    for (int panel = 0; panel < surface.graph.panel_count(); ++panel) {
      double height = 0;
      for (const int v : surface.mesh.faces[surface.graph.panel_faces(panel)[0]]) {
        height += surface.mesh.positions[v].z() / 3;
      }
      if (std::abs(height) < 0.5) continue;  // the neck may go either way
      EXPECT_EQ(labels[panel], height < 0 ? 0 : 1) << "panel at height " << height;
    }
  }
}

TEST(MergeClusters, KeepsAConvexShapeWhole) {
  const Unfoldable surface = unfoldable(icosahedron());
  EXPECT_EQ(merge_clusters(surface.mesh, surface.graph, learn(surface, 50)), Labels(20, 0));
}

TEST(MergeClusters, LeavesComponentsApart) {
  const Unfoldable surface = unfoldable(cube());
  const DualGraph graph = restrict_to(surface.graph, std::vector<int>{0, 1});  // opposite sides
  const FoldabilityMatrix matrix{2, {1, 1, 1, 1}};
  EXPECT_EQ(merge_clusters(surface.mesh, graph, matrix, {.parts = 1}), (Labels{0, 1}));
}

}  // namespace
}  // namespace foldwright::testing
