#include "segment/mirrored_panels.h"

#include <gtest/gtest.h>

#include "drawn_shapes.h"
#include "meshes.h"

namespace foldwright::testing {
namespace {

TEST(MirroredPanels, PairPanelsOfEqualArea) {
  for (const Mesh& mesh : {cube(), l_prism()}) {
    const DualGraph graph = build_dual_graph(mesh);
    const auto mirror = find_mirror(mesh, graph.faces);
    ASSERT_TRUE(mirror);
    const std::vector<int> images = mirrored_panels(mesh, graph, *mirror);
    ASSERT_EQ(static_cast<int>(images.size()), graph.panel_count());
    for (int panel = 0; panel < graph.panel_count(); ++panel) {
      EXPECT_EQ(images[images[panel]], panel);
      EXPECT_NEAR(graph.areas[images[panel]], graph.areas[panel], 1e-6);
    }
  }
}

TEST(MirroredPanels, LieWhereTheImagesAre) {
  const Mesh mesh = bilateral(800);
  const DualGraph graph = build_dual_graph(mesh);
  const std::vector<int> images = mirrored_panels(mesh, graph, {Vec3::UnitX(), 0, 0});
  const auto centroid = [&](int panel) -> Vec3 {
    const auto& [a, b, c] = mesh.faces[graph.panel_faces(panel)[0]];
    return (mesh.positions[a] + mesh.positions[b] + mesh.positions[c]) / 3;
  };
  for (int panel = 0; panel < graph.panel_count(); ++panel) {
    const Vec3 image = centroid(panel).cwiseProduct(Vec3(-1, 1, 1));
    EXPECT_LT((centroid(images[panel]) - image).norm(), 2 * graph.unit);
  }
}

}  // namespace
}  // namespace foldwright::testing
