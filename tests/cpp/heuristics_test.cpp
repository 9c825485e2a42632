#include "unfold/heuristics.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "heuristic_table.h"
#include "meshes.h"
#include "trees.h"
#include "unfold/directions.h"

namespace foldwright::testing {
namespace {

constexpr int kHulls = 200;

/// From the lower or the upper end of a hinge of one edge.
Vec3 end_of(const Mesh& mesh, const Hinge& hinge, int end) {
  return mesh.positions[mesh.edges[hinge.edges[0]].vertices[end]];
}

TEST(FlatTree, WeighsEdgesByTheFormula) {
  Random random(1);
  for (const Mesh& mesh : {star(), cube(), dumbbell()}) {
    const DualGraph graph = build_dual_graph(mesh);
    const Vec3 direction = random_direction(random);
    const std::vector<double> weights = HeuristicWeights(mesh, graph).flat_tree(direction);
    ASSERT_EQ(static_cast<int>(weights.size()), graph.hinge_count());
    for (int h = 0; h < graph.hinge_count(); ++h) {
      const Vec3 edge = end_of(mesh, graph.hinges[h], 1) - end_of(mesh, graph.hinges[h], 0);
      EXPECT_NEAR(weights[h], std::abs(edge.dot(direction)) / edge.norm(), 1e-12);
    }
  }
}

TEST(SteepestEdge, OfACubeByHand) {
  // Direction (1, 2, 4): the steepest way up is along z from the bottom, then along y, then x. So
  // cut are the four edges along z, the two along y at the top, and of those along x the one that
  // ends in the top vertex; the other five fold.
  const Mesh mesh = cube();
  const DualGraph graph = build_dual_graph(mesh);
  const HeuristicWeights heuristic(mesh, graph);
  const std::vector<double> weights = heuristic.steepest_edge(Vec3(1, 2, 4).normalized());
  FoldTree folds;
  for (int h = 0; h < graph.hinge_count(); ++h) {
    const Vec3 middle = 0.5 * (end_of(mesh, graph.hinges[h], 0) + end_of(mesh, graph.hinges[h], 1));
    const bool along_z = middle.z() == 0;
    const bool along_y_on_top = middle.y() == 0 && middle.z() > 0;
    const bool along_x_to_the_top = middle.x() == 0 && middle.y() > 0 && middle.z() > 0;
    const bool cut = along_z || along_y_on_top || along_x_to_the_top;
    EXPECT_EQ(weights[h] >= 1, cut) << middle.transpose();
    if (!cut) folds.push_back(h);
  }
  EXPECT_EQ(minimum_spanning_tree(graph, weights), folds);
}

TEST(SteepestEdge, CutsAtEveryVertexButTheTop) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    for (const Mesh& mesh : {random_hull(seed, 40), star(), torus(12, 7)}) {
      const DualGraph graph = build_dual_graph(mesh);
      const auto weights = HeuristicWeights(mesh, graph).steepest_edge(random_direction(random));
      std::vector<char> is_cut(mesh.positions.size(), 0);
      for (int h = 0; h < graph.hinge_count(); ++h) {
        EXPECT_GE(weights[h], 0);
        EXPECT_LT(weights[h], 2);
        if (weights[h] < 1) continue;
        for (const int v : mesh.edges[graph.hinges[h].edges[0]].vertices) is_cut[v] = 1;
      }
      EXPECT_GE(std::ranges::count(is_cut, 1), mesh.vertex_count() - 1);
    }
  }
}

TEST(SteepestEdge, CutsOneEdgeUpwardsFromEveryVertexOfAConvexHull) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Mesh mesh = random_hull(seed, 40);
    const DualGraph graph = build_dual_graph(mesh);
    const Vec3 direction = random_direction(random);
    const auto weights = HeuristicWeights(mesh, graph).steepest_edge(direction);
    std::vector<int> climbs(mesh.positions.size(), 0);
    for (int h = 0; h < graph.hinge_count(); ++h) {
      if (weights[h] < 1) continue;
      const auto& [a, b] = mesh.edges[graph.hinges[h].edges[0]].vertices;
      const bool b_is_higher = mesh.positions[b].dot(direction) > mesh.positions[a].dot(direction);
      ++climbs[b_is_higher ? a : b];
    }
    EXPECT_EQ(std::ranges::count(climbs, 1), mesh.vertex_count() - 1);
    EXPECT_EQ(std::ranges::count(climbs, 0), 1);  // at the top
  }
}

TEST(SteepestEdge, HasNothingToCutWhereEveryVertexIsOnABorder) {
  const Mesh mesh = accordion({1, 1, 1, 1});
  const DualGraph graph = build_dual_graph(mesh);
  const auto weights = HeuristicWeights(mesh, graph).steepest_edge(Vec3::UnitZ());
  EXPECT_TRUE(std::ranges::all_of(weights, [](double weight) { return weight < 1; }));
}

TEST(SteepestEdge, TakesARestrictedGraphAsASurfaceWithABorder) {
  const Mesh mesh = cube();
  const DualGraph whole = build_dual_graph(mesh);
  const std::vector<int> three_around_a_corner = {0, 2, 4};
  const DualGraph graph = restrict_to(whole, three_around_a_corner);
  ASSERT_EQ(graph.hinge_count(), 3);
  // Only the corner is inside; it is also the top, in whatever direction.
  const auto weights = HeuristicWeights(mesh, graph).steepest_edge(Vec3::UnitX());
  EXPECT_TRUE(std::ranges::all_of(weights, [](double weight) { return weight < 1; }));
}

TEST(Hybrid, AlternatesBetweenTheOtherTwo) {
  const Unfoldable surface = unfoldable(star());
  const HeuristicWeights heuristic(surface.mesh, surface.graph);
  const Vec3 direction = Vec3(3, -1, 2).normalized();
  Random random(1);
  const auto hybrid = [&](int run) {
    return heuristic.weights(Heuristic::kHybrid, direction, run, random);
  };
  EXPECT_EQ(hybrid(0), heuristic.steepest_edge(direction));
  EXPECT_EQ(hybrid(1), heuristic.flat_tree(direction));
  EXPECT_EQ(hybrid(2), heuristic.steepest_edge(direction));
}

TEST(RandomHeuristic, DrawsEveryWeightAnew) {
  const Unfoldable surface = unfoldable(star());
  const HeuristicWeights heuristic(surface.mesh, surface.graph);
  Random random(1);
  const auto draw = [&] { return heuristic.weights(Heuristic::kRandom, Vec3::UnitX(), 0, random); };
  const std::vector<double> first = draw();
  EXPECT_EQ(first.size(), surface.graph.hinges.size());
  EXPECT_NE(first, draw());
}

TEST(HeuristicWeights, AreThoseOfTheHeuristicThatIsAskedFor) {
  const Unfoldable surface = unfoldable(star());
  const HeuristicWeights heuristic(surface.mesh, surface.graph);
  Random random(1);
  const Vec3 direction = random_direction(random);
  const auto weights = [&](Heuristic which, int run) {
    return heuristic.weights(which, direction, run, random);
  };
  EXPECT_EQ(weights(Heuristic::kFlatTree, 0), heuristic.flat_tree(direction));
  EXPECT_EQ(weights(Heuristic::kSteepestEdge, 0), heuristic.steepest_edge(direction));
}

TEST(SteepestEdge, MakesANetOfEveryConvexHull) {
  // A single direction fails for about one hull in a hundred, as known counterexamples let expect.
  constexpr int kDirections = 5;
  const std::vector<Unfoldable> hulls = convex_hulls(kHulls);
  for (int i = 0; i < kHulls; ++i) {
    EXPECT_GT(count_nets(hulls[i], Heuristic::kSteepestEdge, kDirections, i), 0) << "seed " << i;
  }
}

TEST(Heuristics, SucceedOnConvexHullsInTheOrderThatThePaperFinds) {
  constexpr int kDirections = 5;
  const std::vector<Unfoldable> hulls = convex_hulls(kHulls);
  const auto share = [&](Heuristic heuristic) {
    int nets = 0;
    for (int i = 0; i < kHulls; ++i) nets += count_nets(hulls[i], heuristic, kDirections, i);
    return nets / static_cast<double>(kHulls * kDirections);
  };
  const double steepest = share(Heuristic::kSteepestEdge);
  const double flat = share(Heuristic::kFlatTree);
  const double hybrid = share(Heuristic::kHybrid);
  const double random = share(Heuristic::kRandom);
  EXPECT_GT(steepest, 0.98);
  EXPECT_GT(flat, 2 * random);
  EXPECT_LT(random, 0.1);
  // Three of five of its runs are steepest edges, the others flat trees.
  EXPECT_NEAR(hybrid, 0.6 * steepest + 0.4 * flat, 0.03);
}

}  // namespace
}  // namespace foldwright::testing
