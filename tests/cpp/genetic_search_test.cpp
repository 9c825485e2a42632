#include "search/genetic_search.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>

#include "meshes.h"
#include "parts.h"
#include "trees.h"

namespace foldwright {
namespace {

using testing::unfoldable;
using testing::Unfoldable;

/// Face angles around a vertex, summed from the coordinates.
double turn_at(const Mesh& mesh, int vertex) {
  double turn = 0;
  for (const auto& corners : mesh.faces) {
    for (int i = 0; i < 3; ++i) {
      if (corners[i] != vertex) continue;
      const Vec3 a = mesh.positions[corners[(i + 1) % 3]] - mesh.positions[vertex];
      const Vec3 b = mesh.positions[corners[(i + 2) % 3]] - mesh.positions[vertex];
      turn += std::acos(std::clamp(a.dot(b) / (a.norm() * b.norm()), -1.0, 1.0));
    }
  }
  return turn;
}

bool has_vertex(const Mesh& mesh, const DualGraph& graph, int panel, int vertex) {
  for (const int face : graph.panel_faces(panel)) {
    for (const int v : mesh.faces[face]) {
      if (v == vertex) return true;
    }
  }
  return false;
}

/// N_o and N_l by their definitions, from all pairs [paper, 4.3]. For closed surfaces.
Fitness plain_count(const Unfoldable& surface, const FoldTree& folds) {
  const auto pairs = testing::overlaps_of(surface.graph, folds);
  Fitness fitness{static_cast<int>(pairs.size()), 0};
  for (int v = 0; v < surface.mesh.vertex_count(); ++v) {
    if (turn_at(surface.mesh, v) <= 2 * std::numbers::pi + 1e-7) continue;
    bool local = false;
    for (const auto& [a, b] : pairs) {
      local |= has_vertex(surface.mesh, surface.graph, a, v) &&
               has_vertex(surface.mesh, surface.graph, b, v);
    }
    fitness.hyperbolic += local ? 1 : 0;
  }
  return fitness;
}

TEST(FitnessFunction, EqualsAPlainCount) {
  for (const Mesh& mesh : {testing::star(), testing::torus(12, 8), testing::bumpy_sphere(200)}) {
    const Unfoldable surface = unfoldable(mesh);
    const FitnessFunction fitness(surface.mesh, surface.graph);
    Random random(11);
    int local = 0;
    for (int i = 0; i < 20; ++i) {
      const FoldTree folds = testing::random_tree(surface.graph, random);
      const Fitness expected = plain_count(surface, folds);
      const Fitness found = fitness(folds);
      EXPECT_EQ(found.overlaps, expected.overlaps);
      EXPECT_EQ(found.hyperbolic, expected.hyperbolic);
      local += found.hyperbolic;
    }
    EXPECT_GT(local, 0) << "random trees overlap around hyperbolic vertices";
  }
}

TEST(FitnessFunction, WeighsLocalOverlapsTenfold) {
  EXPECT_EQ((Fitness{3, 2}).value({}), -23);
  EXPECT_EQ((Fitness{0, 0}).value({}), 0);
}

TEST(FitnessFunction, DoesNotCountVerticesOnTheBorder) {
  // All faces around the centre of the saddle but one: the centre lies on the border of the rest.
  const Unfoldable surface = unfoldable(testing::saddle(8, 2.5 * std::numbers::pi));
  std::vector<int> panels;
  for (int panel = 1; panel < surface.graph.panel_count(); ++panel) panels.push_back(panel);
  const DualGraph open = restrict_to(surface.graph, panels);
  const FitnessFunction fitness(surface.mesh, open);
  EXPECT_EQ(fitness(testing::all_spanning_trees(open).front()).hyperbolic, 0);
}

/// Evolves from one seed after the other, as the pipeline does.
std::optional<FoldTree> evolve(const Unfoldable& surface) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    GeneticSearch search(surface.mesh, surface.graph, {.generations = 400, .seed = seed});
    while (search.step(5000) == GeneticSearch::State::kRunning) continue;
    if (search.state() == GeneticSearch::State::kFound) return search.best();
  }
  return std::nullopt;
}

TEST(GeneticSearch, FindsNetsThatAnIndependentCheckConfirms) {
  for (const Mesh& mesh :
       {testing::star(), testing::bumpy_sphere(120), testing::random_hull(3, 40)}) {
    const Unfoldable surface = unfoldable(mesh);
    const auto folds = evolve(surface);
    ASSERT_TRUE(folds.has_value()) << mesh.face_count() << " faces";
    EXPECT_TRUE(testing::is_net(surface.mesh, surface.graph, *folds));
  }
}

TEST(GeneticSearch, BestFitnessNeverFalls) {
  const Unfoldable surface = unfoldable(testing::bumpy_sphere(300));
  GeneticSearch search(surface.mesh, surface.graph,
                       {.population = 60, .generations = 30, .seed = 2});
  double best = -1e300;
  int generation = 0;
  while (search.step(1) == GeneticSearch::State::kRunning) {
    EXPECT_GE(search.best_value(), best);
    EXPECT_GE(search.generation(), generation);
    best = search.best_value();
    generation = search.generation();
  }
  EXPECT_GT(generation, 0) << "the search must not be over with its first individuals";
}

TEST(GeneticSearch, DoesNotDependOnTheSlicing) {
  const Unfoldable surface = unfoldable(testing::torus(10, 8));
  const GeneticOptions options = {.population = 80, .generations = 50, .seed = 9};
  GeneticSearch whole(surface.mesh, surface.graph, options);
  GeneticSearch sliced(surface.mesh, surface.graph, options);
  while (whole.step(1'000'000'000) == GeneticSearch::State::kRunning) continue;
  while (sliced.step(1) == GeneticSearch::State::kRunning) continue;
  EXPECT_EQ(whole.best(), sliced.best());
  EXPECT_EQ(whole.generation(), sliced.generation());
}

TEST(GeneticSearch, GivesUpAfterItsGenerations) {
  const Unfoldable surface = unfoldable(testing::saddle(8, 2.5 * std::numbers::pi));
  GeneticSearch search(surface.mesh, surface.graph, {.population = 50, .generations = 20});
  while (search.step(1000) == GeneticSearch::State::kRunning) continue;
  EXPECT_EQ(search.state(), GeneticSearch::State::kGaveUp);
  EXPECT_EQ(search.generation(), 20);
  EXPECT_GT(search.best_fitness().overlaps, 0);
  EXPECT_EQ(search.best_fitness().hyperbolic, 1);
}

}  // namespace
}  // namespace foldwright
