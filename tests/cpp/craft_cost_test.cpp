#include "paper/craft_cost.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "meshes.h"
#include "paper/flaps.h"
#include "search/moving_layout.h"
#include "search/tree_search.h"
#include "trees.h"

namespace foldwright::testing {
namespace {

constexpr double kNoLimit = std::numeric_limits<double>::infinity();

FoldTree net_of(const Mesh& mesh, const DualGraph& graph) {
  TreeSearch search(mesh, graph);
  while (search.step(100000) == TreeSearch::State::kRunning) continue;
  EXPECT_EQ(search.best_overlaps(), 0);
  return search.best();
}

double cost_of(const Mesh& mesh, const DualGraph& graph, const CraftOptions& options,
               const FoldTree& folds) {
  CraftCost cost(mesh, graph, options);
  cost.lay(folds, lay_out(graph, hang_tree(graph, folds)));
  return cost.cost();
}

CraftOptions only(const CraftWeights& weights, double scale) {
  CraftOptions options;
  options.scale = scale;
  options.weights = weights;
  return options;
}

TEST(CraftCost, OfACubeIsThatOfItsHull) {
  const Mesh mesh = cube();
  const DualGraph graph = build_dual_graph(mesh);
  const FoldTree cross = net_of(mesh, graph);
  const double cost = cost_of(mesh, graph, only({0, 1, 0, 0, 0}, 20), cross);
  const Net net = make_net(mesh, graph, cross);
  const std::vector<Vec2> hull = convex_hull(net.vertices);
  double twice = 0;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    twice += foldwright::cross(hull[i], hull[(i + 1) % hull.size()]);
  }
  EXPECT_NEAR(cost, 0.5 * twice / 6, 0.05 * cost);
}

TEST(CraftCost, CountsNoCutThatIsTooShortForAFlap) {
  // Edges of 2 mm hold by their neighbours.
  const Mesh mesh = icosahedron();
  const DualGraph graph = build_dual_graph(mesh);
  EXPECT_EQ(cost_of(mesh, graph, only({1, 0, 0, 0, 0}, 2), net_of(mesh, graph)), 0);
}

TEST(CraftCost, HasRoomForFlapsAsTheyAreThenPlaced) {
  // With one flap to a seam and no other in its way, what is counted as missing is what placing
  // them finds missing.
  for (const int faces : {60, 120, 200}) {
    SCOPED_TRACE(faces);
    const Mesh mesh = bumpy_sphere(faces);
    const DualGraph graph = build_dual_graph(mesh);
    const FoldTree folds = net_of(mesh, graph);
    const double scale = 60;
    std::vector<Net> nets = {make_net(mesh, graph, folds)};
    for (Vec2& p : nets[0].vertices) p *= scale;
    const FlapPlan plan = place_flaps(mesh, nets, {});
    const double cost = cost_of(mesh, graph, only({1, 0, 0, 0, 0}, scale), folds);
    const auto missing = static_cast<double>(plan.missed.size());
    // At most 1.35 for each that is missing, and 0.5 for each that is low.
    EXPECT_LE(cost, 1.35 * missing + 0.5 * plan.counts.shrunk + 1e-9);
    EXPECT_GE(cost, 0.8 * (missing - 2)) << "flaps block each other rarely";
  }
}

TEST(CraftCost, CountsNecks) {
  // Eight squares on either side of a fold of 1 mm length: one neck.
  const Mesh mesh = accordion(std::vector<double>(30, 3));
  const DualGraph graph = build_dual_graph(mesh);
  const FoldTree folds = net_of(mesh, graph);
  const double necks = cost_of(mesh, graph, only({0, 0, 1, 0, 0}, 1), folds);
  // 30 panels of two triangles: folds with eight faces or more on both sides.
  EXPECT_EQ(necks, 29 - 2 * 3);
  EXPECT_EQ(cost_of(mesh, graph, only({0, 0, 1, 0, 0}, 6), folds), 0) << "folds of 6 mm hold";
}

TEST(CraftCost, CountsWhatSticksOutOfTheSheet) {
  // A square, to which all other turns than the upright ones are worse.
  const Mesh mesh = open_strip(1);
  const DualGraph graph = build_dual_graph(mesh);
  CraftOptions options = only({0, 0, 0, 1, 0}, 300);
  options.room = {190, 277};
  EXPECT_NEAR(cost_of(mesh, graph, options, {}), (300 - 190) + (300 - 277), 0.01);
}

TEST(CraftCost, ReliesOnTheOtherSideOfABorder) {
  const Mesh mesh = icosahedron();
  const DualGraph whole = build_dual_graph(mesh);
  const std::vector<int> panels = {0, 1, 2, 3, 4};
  const DualGraph graph = restrict_to(whole, panels);
  const FoldTree folds = net_of(mesh, graph);
  CraftOptions options = only({1, 0, 0, 0, 0}, 10);
  const double alone = cost_of(mesh, graph, options, folds);
  for (int e = 0; e < mesh.edge_count(); ++e) {
    const auto& faces = mesh.edges[e].faces;
    if ((faces[0] < 5) != (faces[1] < 5)) options.borders.push_back({e, 5});
  }
  ASSERT_FALSE(options.borders.empty());
  EXPECT_EQ(cost_of(mesh, graph, options, folds), alone) << "full flaps on the other side";
  CraftCost cost(mesh, graph, options);
  cost.lay(folds, lay_out(graph, hang_tree(graph, folds)));
  EXPECT_EQ(cost.border_rooms().size(), options.borders.size());
  for (const BorderRoom& room : cost.border_rooms()) {
    EXPECT_GE(room.height, 0);
    EXPECT_LE(room.height, 5);
  }
}

TEST(CraftCost, StaysTrueOverManySwaps) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    SCOPED_TRACE(seed);
    const Mesh mesh = bumpy_sphere(120);
    const DualGraph graph = build_dual_graph(mesh);
    const CraftOptions options = only({1, 3, 0.5, 0, 0}, 40);
    const FoldTree folds = net_of(mesh, graph);
    MovingLayout layout(graph, folds);
    CraftCost cost(mesh, graph, options);
    cost.lay(folds, layout.flat().places());
    Random random(seed);
    std::vector<int> path;
    int accepted = 0;
    for (int move = 0; move < 3000 && accepted < 60; ++move) {
      const int join = random.below(graph.hinge_count());
      if (layout.tree().is_fold(join)) continue;
      layout.path(graph.hinges[join].panels[0], graph.hinges[join].panels[1], path);
      layout.select_side(path[random.below(static_cast<int>(path.size()))]);
      if (layout.try_flat(join, 0) > 0) continue;
      const double before = cost.cost();
      const double after = cost.try_swap(
          {layout.tree().cut(), join, layout.tree().selected(), layout.flat().trial_motion()},
          kNoLimit);
      EXPECT_EQ(cost.cost(), before) << "a trial changes nothing";
      if (random.below(3) == 0) continue;
      layout.accept();
      cost.accept();
      ++accepted;
      ASSERT_NEAR(cost.cost(), after, 1e-9);
      // Anew, the silhouette differs by rounding and by the turn of the whole net.
      CraftCost anew(mesh, graph, options);
      anew.lay(layout.folds(), layout.flat().places());
      ASSERT_NEAR(cost.cost(), anew.cost(), 1e-4) << "after " << accepted << " swaps";
    }
    EXPECT_GE(accepted, 20);
  }
}

}  // namespace
}  // namespace foldwright::testing
