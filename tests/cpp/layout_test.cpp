#include "unfold/layout.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "drawn_shapes.h"
#include "meshes.h"
#include "trees.h"

namespace foldwright::testing {
namespace {

struct Laid {
  DualGraph graph;
  FoldTree folds;
  Layout layout;
};

Laid lay_out_randomly(const Mesh& mesh, Random& random) {
  Laid laid{build_dual_graph(mesh), {}, {}};
  laid.folds = random_tree(laid.graph, random);
  laid.layout = lay_out(laid.graph, hang_tree(laid.graph, laid.folds));
  return laid;
}

/// A panel's triangles in their places.
std::vector<Triangle2> placed(const Laid& laid, int panel) {
  std::vector<Triangle2> triangles;
  for (const Triangle2& triangle : laid.graph.panel_triangles(panel)) {
    triangles.push_back(moved(laid.layout[panel], triangle));
  }
  return triangles;
}

double shared_area(const Laid& laid, int a, int b) {
  double sum = 0;
  for (const Triangle2& s : placed(laid, a)) {
    for (const Triangle2& t : placed(laid, b)) sum += intersection_area(s, t);
  }
  return sum;
}

TEST(LayOut, KeepsEveryPanelAndEveryFoldTogether) {
  Random random(1);
  for (const Mesh& mesh : {cube(), star(), torus(12, 8), l_prism(), dumbbell()}) {
    SCOPED_TRACE(mesh.face_count());
    const Laid laid = lay_out_randomly(mesh, random);
    for (const RigidMotion2& motion : laid.layout) {
      EXPECT_NEAR(motion.c * motion.c + motion.s * motion.s, 1, 1e-14);
    }
    for (const int h : laid.folds) {
      // Seen from one panel, the other must lie as the hinge says.
      const auto [low, high] = laid.graph.hinges[h].panels;
      const RigidMotion2 between = laid.layout[low].inverse() * laid.layout[high];
      EXPECT_NEAR(between.c, laid.graph.hinges[h].lay.c, 1e-12);
      EXPECT_NEAR(between.s, laid.graph.hinges[h].lay.s, 1e-12);
      EXPECT_LT((between.t - laid.graph.hinges[h].lay.t).norm(), 1e-12 * laid.layout.size());
    }
  }
}

TEST(LayOut, LeavesTheRootWhereItIs) {
  const DualGraph graph = build_dual_graph(icosahedron());
  Random random(2);
  const Layout layout = lay_out(graph, hang_tree(graph, random_tree(graph, random), 7));
  EXPECT_EQ(layout[7].c, 1);
  EXPECT_EQ(layout[7].s, 0);
  EXPECT_EQ(layout[7].t, Vec2(0, 0));
}

TEST(OverlappingPanels, AreThoseThatShareArea) {
  int overlapping = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    for (const Mesh& mesh : {random_hull(seed, 30), star(), l_prism(), torus(8, 6)}) {
      const Laid laid = lay_out_randomly(mesh, random);
      const auto found = overlapping_panels(laid.graph, laid.layout);
      overlapping += static_cast<int>(found.size());
      EXPECT_TRUE(std::ranges::is_sorted(found));
      const double tolerance = 4 * kOverlapTolerance * laid.graph.unit * laid.graph.unit;
      for (int a = 0; a < laid.graph.panel_count(); ++a) {
        for (int b = a + 1; b < laid.graph.panel_count(); ++b) {
          const double area = shared_area(laid, a, b);
          if (std::ranges::binary_search(found, std::array{a, b})) {
            EXPECT_GT(area, 0) << a << " and " << b;
          } else {
            EXPECT_LT(area, tolerance) << a << " and " << b;
          }
        }
      }
    }
  }
  EXPECT_GT(overlapping, 100);
}

TEST(OverlappingPanels, AreTheEndsOfAFanOfMoreThanAFullTurn) {
  const DualGraph graph = build_dual_graph(saddle(8, 7));  // 50 degrees each, 401 in all
  for (const FoldTree& folds : all_spanning_trees(graph)) {
    const auto overlaps = overlaps_of(graph, folds);
    ASSERT_EQ(overlaps.size(), 1u);
    // The two panels at the hinge that is cut.
    for (int h = 0; h < 8; ++h) {
      if (std::ranges::binary_search(folds, h)) continue;
      EXPECT_EQ(overlaps[0], graph.hinges[h].panels);
    }
  }
}

}  // namespace
}  // namespace foldwright::testing
