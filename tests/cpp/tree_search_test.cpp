#include "search/tree_search.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "drawn_shapes.h"
#include "folding.h"
#include "meshes.h"
#include "parts.h"
#include "repair/repair.h"
#include "trees.h"

namespace foldwright::testing {
namespace {

using State = TreeSearch::State;

constexpr std::int64_t kToTheEnd = std::numeric_limits<std::int64_t>::max();

/// Searches a net of a mesh to the end and checks what comes out.
void expect_net(const Mesh& mesh) {
  const DualGraph graph = build_dual_graph(mesh);
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE(seed);
    TreeSearch search(mesh, graph, {.seed = seed});
    EXPECT_EQ(search.step(kToTheEnd), State::kFound);
    EXPECT_EQ(search.best_overlaps(), 0);
    EXPECT_TRUE(is_net(mesh, graph, search.best()));
  }
}

TEST(TreeSearch, UnfoldsAPrismAsAStripWithTwoLids) {
  constexpr double kHeight = 3;
  const Mesh mesh = prism(32, kHeight);
  const DualGraph graph = build_dual_graph(mesh);
  ASSERT_EQ(graph.panel_count(), 34);
  TreeSearch search(mesh, graph);
  while (search.step(100000) == TreeSearch::State::kRunning) continue;
  ASSERT_EQ(search.best_overlaps(), 0);
  double cut = 0;
  for (const Hinge& hinge : graph.hinges) cut += hinge.length;
  for (const int h : search.best()) cut -= graph.hinges[h].length;
  const double side = 2 * std::sin(std::numbers::pi / 32);
  EXPECT_NEAR(cut, kHeight + 2 * 31 * side, 1e-9) << "one wall, and both lids but for a side";
}

TEST(TreeSearch, FindsANetOfACube) { expect_net(cube()); }
TEST(TreeSearch, FindsANetOfATetrahedron) { expect_net(tetrahedron()); }
TEST(TreeSearch, FindsANetOfAnIcosahedron) { expect_net(icosahedron()); }
TEST(TreeSearch, FindsANetOfAStar) { expect_net(star()); }
TEST(TreeSearch, FindsANetOfATorus) { expect_net(torus(16, 9)); }
TEST(TreeSearch, FindsANetOfAnOpenStrip) { expect_net(open_strip(5)); }
TEST(TreeSearch, FindsANetOfAFoldedStrip) { expect_net(accordion({1, 2, 1, 3})); }
TEST(TreeSearch, FindsANetOfAMoebiusStrip) { expect_net(repair(mobius_strip(9)).mesh); }
TEST(TreeSearch, FindsANetOfADumbbell) { expect_net(dumbbell()); }
TEST(TreeSearch, FindsANetOfATwoSidedSquare) { expect_net(two_sided_square()); }

TEST(TreeSearch, FindsANetOfBumpySpheres) {
  for (const int faces : {100, 300, 600}) {
    SCOPED_TRACE(faces);
    expect_net(bumpy_sphere(faces));
  }
}

TEST(TreeSearch, GivesUpWhereThereIsNoNet) {
  // More than a full turn around a vertex with a single cut to it: the ends of the fan overlap.
  const Mesh mesh = saddle(8, 7);
  const DualGraph graph = build_dual_graph(mesh);
  for (const FoldTree& folds : all_spanning_trees(graph)) {
    ASSERT_FALSE(is_net(mesh, graph, folds)) << "there is a net after all";
  }
  TreeSearch search(mesh, graph, {.patience = 500});
  EXPECT_EQ(search.step(kToTheEnd), State::kGaveUp);
  EXPECT_EQ(search.step(1000), State::kGaveUp);
  EXPECT_EQ(search.impatience(), 1);
  EXPECT_EQ(search.best_overlaps(), 1);
  EXPECT_EQ(overlaps_of(graph, search.best()).size(), 1u);
}

TEST(TreeSearch, GivesUpWhereNothingCanBeSwapped) {
  // The fan, cut open: one spanning tree, which overlaps.
  const Mesh closed = saddle(8, 9);
  std::vector<std::array<int, 3>> faces = closed.faces;
  faces.pop_back();
  const Mesh mesh = make_mesh(closed.positions, faces);
  const DualGraph graph = build_dual_graph(mesh);
  ASSERT_EQ(all_spanning_trees(graph).size(), 1u);
  TreeSearch search(mesh, graph, {.patience = 100});
  EXPECT_EQ(search.step(kToTheEnd), State::kGaveUp);
  EXPECT_GT(search.best_overlaps(), 0);
}

TEST(TreeSearch, DoesNotDependOnTheSlicing) {
  const Unfoldable surface = unfoldable(bumpy_sphere(500));
  const auto run = [&](std::int64_t slice) {
    TreeSearch search(surface.mesh, surface.graph, {.starts = 2, .seed = 4});
    while (search.step(slice) == State::kRunning) continue;
    return std::tuple(search.state(), search.best(), search.moves());
  };
  const auto at_once = run(kToTheEnd);
  EXPECT_GT(std::get<2>(at_once), 0) << "found without a search";
  for (const std::int64_t slice : {1, 37, 5000}) EXPECT_EQ(run(slice), at_once);
}

TEST(TreeSearch, DependsOnTheSeed) {
  const Unfoldable surface = unfoldable(bumpy_sphere(300));
  const auto best = [&](std::uint64_t seed) {
    TreeSearch search(surface.mesh, surface.graph, {.seed = seed});
    search.step(kToTheEnd);
    return search.best();
  };
  EXPECT_EQ(best(1), best(1));
  EXPECT_NE(best(1), best(2));
}

TEST(TreeSearch, NeverLosesItsBest) {
  const Unfoldable surface = unfoldable(bumpy_sphere(600));
  TreeSearch search(surface.mesh, surface.graph, {.starts = 1});
  search.step(1);
  for (int before = search.best_overlaps(); search.step(200) == State::kRunning;) {
    EXPECT_LE(search.best_overlaps(), before);
    before = search.best_overlaps();
    EXPECT_EQ(static_cast<int>(overlaps_of(surface.graph, search.best()).size()), before);
    EXPECT_GE(search.impatience(), 0);
    EXPECT_LE(search.impatience(), 1);
  }
}

/// Whether the best tree of a search is a net that folds straight, by means of its own.
void expect_to_fold(const Mesh& mesh, const DualGraph& graph, const TreeSearch& search) {
  EXPECT_TRUE(is_net(mesh, graph, search.best()));
  EXPECT_EQ(search.best_overlaps(), 0);
  EXPECT_EQ(search.best_collisions(), 0);
  EXPECT_EQ(search.shortfall(), 0);
  EXPECT_TRUE(search.conflicts().empty());
  const Foldable foldable = make_foldable(graph);
  Certificate certificate(foldable, search.best(), straight_leg(graph));
  EXPECT_EQ(certificate.step(kToTheEnd), Certificate::State::kCertified);
  const PlainFolder folder(mesh, graph, search.best());
  EXPECT_TRUE(colliding_times(folder, fold_angles(graph, 0), fold_angles(graph, 1), 200).empty());
}

TEST(TreeSearch, FindsNetsThatFoldWhenAskedTo) {
  for (const Mesh& mesh : {cube(), tetrahedron(), icosahedron(), l_prism(), two_sided_square(),
                           open_strip(4), accordion({1, 2, 1}), bumpy_sphere(150), dumbbell()}) {
    const DualGraph graph = build_dual_graph(mesh);
    SCOPED_TRACE(graph.panel_count());
    for (std::uint64_t seed = 1; seed <= 2; ++seed) {
      SCOPED_TRACE(seed);
      TreeSearch search(mesh, graph, {.clearance = kClearance, .seed = seed});
      ASSERT_EQ(search.step(kToTheEnd), State::kFound);
      expect_to_fold(mesh, graph, search);
    }
  }
}

TEST(TreeSearch, GivesUpWhereNothingFolds) {
  // No net at all, and a net of a model that meets itself.
  const Unfoldable fan = unfoldable(saddle(8, 7));
  TreeSearch no_net(fan.mesh, fan.graph, {.patience = 500, .clearance = kClearance});
  EXPECT_EQ(no_net.step(kToTheEnd), State::kGaveUp);
  EXPECT_GT(no_net.best_overlaps(), 0);
  EXPECT_GT(no_net.shortfall(), 0);
  const Unfoldable strip = unfoldable(crossing_strip());
  TreeSearch no_motion(strip.mesh, strip.graph, {.patience = 500, .clearance = kClearance});
  EXPECT_EQ(no_motion.step(kToTheEnd), State::kGaveUp);
  EXPECT_EQ(no_motion.best_overlaps(), 0);
  EXPECT_GT(no_motion.shortfall(), 0);
  EXPECT_EQ(no_motion.step(1000), State::kGaveUp);
}

TEST(TreeSearch, DoesNotDependOnTheSlicingWhenItFolds) {
  const Unfoldable surface = unfoldable(bumpy_sphere(150));
  const auto run = [&](std::int64_t slice) {
    TreeSearch search(surface.mesh, surface.graph,
                      {.starts = 2, .clearance = kClearance, .seed = 4});
    while (search.step(slice) == State::kRunning) continue;
    return std::tuple(search.state(), search.best(), search.moves(), search.shortfall());
  };
  const auto at_once = run(kToTheEnd);
  for (const std::int64_t slice : {1, 37, 5000}) EXPECT_EQ(run(slice), at_once);
}

TEST(TreeSearch, KeepsItsNetWhileItSearchesOneThatFolds) {
  const Unfoldable surface = unfoldable(bumpy_sphere(250));
  TreeSearch search(surface.mesh, surface.graph, {.clearance = kClearance, .seed = 3});
  search.step(1);
  for (int before = search.best_overlaps(); search.step(500) == State::kRunning;) {
    EXPECT_LE(search.best_overlaps(), before);
    before = search.best_overlaps();
    EXPECT_EQ(static_cast<int>(overlaps_of(surface.graph, search.best()).size()), before);
    EXPECT_GT(search.shortfall(), 0);
  }
  EXPECT_EQ(search.state(), State::kFound);
}

TEST(TreeSearch, StartsFromATreeThatIsGiven) {
  const Unfoldable surface = unfoldable(bumpy_sphere(200));
  Random random(1);
  const FoldTree initial = random_tree(surface.graph, random);
  TreeSearch search(surface.mesh, surface.graph, {}, initial);
  const auto overlaps = static_cast<int>(overlaps_of(surface.graph, initial).size());
  ASSERT_GT(overlaps, 10);
  TreeSearch content(surface.mesh, surface.graph, {.good_enough = overlaps}, initial);
  EXPECT_EQ(content.step(kToTheEnd), State::kFound);
  EXPECT_EQ(content.best(), initial);
  EXPECT_EQ(content.moves(), 0);
  EXPECT_EQ(search.step(kToTheEnd), State::kFound);
  EXPECT_TRUE(is_net(surface.mesh, surface.graph, search.best()));
}

}  // namespace
}  // namespace foldwright::testing
