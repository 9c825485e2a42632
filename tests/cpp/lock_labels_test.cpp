#include "segment/lock_labels.h"

#include <gtest/gtest.h>

#include <set>

#include "meshes.h"
#include "segment/segment.h"

namespace foldwright::testing {
namespace {

DualGraph locked_at(const Mesh& mesh, const std::vector<int>& edges) {
  std::vector<EdgeLock> locks;
  for (const int e : edges) locks.push_back({mesh.edges[e].vertices, true});
  return lock_edges(mesh, build_dual_graph(mesh), locks);
}

bool parts_hang_together(const DualGraph& graph, const Labels& labels) {
  const Labels pieces = part_pieces(graph, labels);
  return part_count(pieces) == static_cast<int>(std::set(labels.begin(), labels.end()).size());
}

/// A strip of squares, of which the first ones are part 0 and the others part 1.
Labels two_ends(const DualGraph& graph, int first) {
  Labels labels(graph.panel_count(), 1);
  for (int panel = 0; panel < first; ++panel) labels[panel] = 0;
  return labels;
}

TEST(KeepLockedTogether, LeavesLabelsWithoutLocksAlone) {
  const DualGraph graph = build_dual_graph(torus(8, 6));
  Labels labels(graph.panel_count(), 0);
  labels[3] = 5;
  EXPECT_EQ(keep_locked_together(graph, labels), labels);
}

TEST(KeepLockedTogether, MovesAGroupToThePartWithMostOfIt) {
  const Mesh mesh = accordion({1, 1, 1, 1, 1, 1});
  const DualGraph plain = build_dual_graph(mesh);
  ASSERT_EQ(plain.panel_count(), 6);
  // Panels 1 to 3 are held together; two of them are in the second part.
  const DualGraph graph = locked_at(mesh, {plain.hinges[1].edges[0], plain.hinges[2].edges[0]});
  EXPECT_EQ(keep_locked_together(graph, two_ends(graph, 2)), two_ends(graph, 1));
  EXPECT_EQ(keep_locked_together(graph, two_ends(graph, 3)), two_ends(graph, 4));
}

TEST(KeepLockedTogether, RenumbersWhatIsLeftOfVanishedParts) {
  const Mesh mesh = accordion({1, 1, 1, 1});
  const DualGraph plain = build_dual_graph(mesh);
  const DualGraph graph = locked_at(mesh, {plain.hinges[0].edges[0], plain.hinges[1].edges[0]});
  EXPECT_EQ(keep_locked_together(graph, {0, 1, 1, 2}), (Labels{0, 0, 0, 1}));
}

TEST(KeepLockedTogether, KeepsPartsConnected) {
  const Mesh mesh = bumpy_sphere(200);
  const DualGraph plain = build_dual_graph(mesh);
  Random random(3);
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<int> edges;
    const int count = 1 + random.below(25);
    for (int i = 0; i < count; ++i) {
      edges.push_back(plain.hinges[random.below(plain.hinge_count())].edges[0]);
    }
    const DualGraph graph = locked_at(mesh, edges);
    // Parts that are grown from a few panels.
    Labels labels(graph.panel_count(), -1);
    std::vector<int> open;
    for (int part = 0; part < 5; ++part) {
      const int panel = random.below(graph.panel_count());
      if (labels[panel] == -1) labels[panel] = part, open.push_back(panel);
    }
    for (std::size_t next = 0; next < open.size(); ++next) {
      for (const int h : graph.hinges_of(open[next])) {
        const int beyond = graph.hinges[h].other(open[next]);
        if (labels[beyond] == -1) labels[beyond] = labels[open[next]], open.push_back(beyond);
      }
    }
    labels = renumbered(labels);
    const Labels kept = keep_locked_together(graph, labels);
    EXPECT_TRUE(parts_hang_together(graph, kept)) << "trial " << trial;
    for (const Hinge& hinge : graph.hinges) {
      if (!hinge.stays_fold) continue;
      EXPECT_EQ(kept[hinge.panels[0]], kept[hinge.panels[1]]);
    }
  }
}

TEST(IsHeldTogether, IsSoWhenNoFoldIsLeftToCut) {
  const Mesh mesh = accordion({1, 1, 1});
  const DualGraph plain = build_dual_graph(mesh);
  const int first = plain.hinges[0].edges[0];
  const int second = plain.hinges[1].edges[0];
  EXPECT_FALSE(is_held_together(plain));
  EXPECT_FALSE(is_held_together(locked_at(mesh, {first})));
  EXPECT_TRUE(is_held_together(locked_at(mesh, {first, second})));
}

TEST(HalveBetweenLocks, AlwaysMakesHalves) {
  const Mesh mesh = accordion({1, 1, 1, 1});
  const DualGraph plain = build_dual_graph(mesh);
  const DualGraph graph = locked_at(mesh, {plain.hinges[0].edges[0], plain.hinges[1].edges[0]});
  // Halved in the middle of what is held together.
  const Labels halves = halve_between_locks(graph, {0, 0, 1, 1});
  EXPECT_EQ(halves[0], halves[1]);
  EXPECT_EQ(halves[1], halves[2]);
  EXPECT_NE(halves[2], halves[3]);
}

}  // namespace
}  // namespace foldwright::testing
