#include "pipeline/wire.h"

#include <gtest/gtest.h>

#include "meshes.h"

namespace foldwright {
namespace {

std::vector<int> all_panels(const Surface& surface) {
  std::vector<int> panels;
  for (int panel = 0; panel < surface.graph.panel_count(); ++panel) panels.push_back(panel);
  return panels;
}

/// Runs a task here, and again after it has travelled as bytes; both results as bytes.
std::pair<Bytes, Bytes> run_both(const Task& task) {
  const auto run = [](Task copy) {
    TaskRunner runner(std::move(copy));
    while (!runner.step(1000)) continue;
    return encode(runner.result());
  };
  const auto surface = decode_surface(encode(*task.surface));
  return {run(task), run(decode_task(encode(task), surface))};
}

TEST(Wire, CarriesSurfaces) {
  const auto surface = make_surface(3, testing::torus(7, 5));
  const auto copy = decode_surface(encode(*surface));
  EXPECT_EQ(copy->key, 3);
  EXPECT_EQ(copy->mesh.positions, surface->mesh.positions);
  EXPECT_EQ(copy->mesh.faces, surface->mesh.faces);
  EXPECT_EQ(copy->mesh.source_faces, surface->mesh.source_faces);
  EXPECT_EQ(copy->graph.hinge_count(), surface->graph.hinge_count());
}

TEST(Wire, ATravelledTaskGivesTheSameResult) {
  const auto surface = make_surface(0, testing::torus(9, 6));
  const LearnOptions learning = {.heuristic = Heuristic::kHybrid, .runs = 20, .seed = 4};
  const auto works =
      std::vector<Work>{LearnTask{learning, 5, 20}, SearchTask{{.temperature = 1, .seed = 7}},
                        GeneticTask{{.population = 40, .generations = 30, .seed = 8}}};
  for (const Work& work : works) {
    const auto [here, there] = run_both({1, surface, all_panels(*surface), work});
    EXPECT_EQ(here, there) << "kind " << work.index();
  }
}

TEST(Wire, CarriesABorderExchange) {
  const auto surface = make_surface(0, testing::torus(8, 6));
  ExchangeTask work;
  const int n = surface->graph.panel_count();
  for (int panel = 0; panel < n; ++panel) work.parts.labels.push_back(2 * panel / n);
  work.parts.fold_edges = {1, 5, 8};
  work.parts.overlaps = {{1, 4}};
  work.options = {.part = 0, .most_steps = 5, .most_moves = 1000, .seed = 6};
  const auto [here, there] = run_both({2, surface, all_panels(*surface), work});
  EXPECT_EQ(here, there);
}

TEST(Wire, CarriesStatusesAndResults) {
  TaskStatus status;
  status.progress = 0.25;
  status.runs = 12;
  status.generations = {{-13, 3, 1}, {-2, 2, 0}};
  status.net = NetPicture{{0, 1, 2, 3, 4, 5}, {7}, {1}};
  const TaskStatus copy = decode_status(encode(status));
  EXPECT_EQ(copy.progress, 0.25);
  EXPECT_EQ(copy.runs, 12);
  ASSERT_EQ(copy.generations.size(), 2u);
  EXPECT_EQ(copy.generations[0].hyperbolic, 1);
  ASSERT_TRUE(copy.net.has_value());
  EXPECT_EQ(copy.net->corners, status.net->corners);

  const TaskResult result = ExchangeResult{true, {0, 1, 1}, {{1, {4, 5}}}, {{0, 2}}, 99};
  const auto exchange = std::get<ExchangeResult>(decode_result(encode(result)));
  EXPECT_TRUE(exchange.found);
  EXPECT_EQ(exchange.labels, (std::vector<int>{0, 1, 1}));
  EXPECT_EQ(exchange.changed.at(1), (FoldTree{4, 5}));
  EXPECT_EQ(exchange.overlaps.at(0), 2);
  EXPECT_EQ(exchange.moves, 99);
}

}  // namespace
}  // namespace foldwright
