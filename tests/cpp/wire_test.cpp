#include "pipeline/wire.h"

#include <gtest/gtest.h>

#include <limits>
#include <numeric>

#include "meshes.h"

namespace foldwright::testing {
namespace {

TaskResult run(Task task) {
  TaskRunner runner(std::move(task));
  while (!runner.step(std::numeric_limits<std::int64_t>::max())) continue;
  return runner.result();
}

/// Every kind of work, with all options other than by default.
std::vector<Work> all_kinds_of_work() {
  const LearnOptions learn = {Heuristic::kHybrid, DirectionSet::kEdges, 9, 77};
  const TreeSearchOptions search = {.starts = 3,
                                    .temperature = 0.7,
                                    .patience = 60,
                                    .good_enough = 1,
                                    .clearance = 0.02,
                                    .seed = 5};
  const GeneticOptions genetic = {.population = 12,
                                  .offspring = 4,
                                  .generations = 6,
                                  .tournament = 3,
                                  .crossover = 0.3,
                                  .mutation = 0.1,
                                  .step = 0.2,
                                  .overlap_cost = 2,
                                  .hyperbolic_cost = 3,
                                  .seed = 8};
  const PartsSoFar parts = {{0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1}, {2, 3, 5, 6}, {{0, 1}}};
  const ExchangeOptions exchange = {.part = 0,
                                    .most_steps = 40,
                                    .most_moves = 100000,
                                    .temperature = 0.9,
                                    .clearance = 0.03,
                                    .seed = 6};
  const FoldTree folds = {0, 1, 2, 3, 4, 5, 6, 8, 9, 10};
  return {LearnTask{learn, 2, 7}, SearchTask{search, folds}, GeneticTask{genetic},
          ExchangeTask{parts, exchange}, PlanTask{folds, 0.04, 10}};
}

/// Making a net better to craft, with all options other than by default.
CompactTask compact_task(FoldTree folds) {
  CompactTask compact{std::move(folds), {}, {}};
  compact.craft = {.scale = 12,
                   .shape = {.height = 4, .least = 1.5, .angles = {0.9, 0.8}},
                   .weights = {.flaps = 1.1, .hull = 2, .necks = 0.4, .excess = 0.7},
                   .room = {150, 200},
                   .borders = {{3, 2.5}}};
  compact.annealing = {.work = 5000, .hot = 0.2, .cold = 0.03, .clearance = 0.02, .seed = 12};
  return compact;
}

TEST(Wire, CarriesTasksThatGiveTheSameResult) {
  const auto surface = make_surface(3, saddle_with_apron(7, 3));
  const auto copy = decode_surface(encode(*surface));
  for (const Work& work : all_kinds_of_work()) {
    SCOPED_TRACE(work.index());
    const Task task = {42, surface, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10}, work};
    const Task carried = decode_task(encode(task), copy);
    EXPECT_EQ(carried.id, 42);
    EXPECT_EQ(carried.surface, copy);
    EXPECT_EQ(carried.panels, task.panels);
    EXPECT_EQ(carried.work.index(), work.index());
    const Bytes result = encode(run(task));
    EXPECT_EQ(encode(run(carried)), result);
    EXPECT_EQ(encode(decode_result(result)), result);
  }
}

TEST(Wire, CarriesEveryOptionOfATask) {
  // A field that is left out would come back with its default.
  const auto surface = make_surface(0, saddle_with_apron(7, 3));
  const auto carried = [&](int kind) {
    return decode_task(encode(Task{0, surface, {0}, all_kinds_of_work()[kind]}), surface).work;
  };
  const LearnTask learn = std::get<LearnTask>(carried(0));
  EXPECT_EQ(learn.options.heuristic, Heuristic::kHybrid);
  EXPECT_EQ(learn.options.directions, DirectionSet::kEdges);
  EXPECT_EQ(learn.options.runs, 9);
  EXPECT_EQ(learn.options.seed, 77u);
  EXPECT_EQ(learn.first_run, 2);
  EXPECT_EQ(learn.last_run, 7);
  const TreeSearchOptions search = std::get<SearchTask>(carried(1)).options;
  EXPECT_EQ(search.starts, 3);
  EXPECT_EQ(search.temperature, 0.7);
  EXPECT_EQ(search.patience, 60);
  EXPECT_EQ(search.good_enough, 1);
  EXPECT_EQ(search.clearance, 0.02);
  EXPECT_EQ(search.seed, 5u);
  EXPECT_EQ(std::get<SearchTask>(carried(1)).initial.size(), 10u);
  const GeneticOptions genetic = std::get<GeneticTask>(carried(2)).options;
  EXPECT_EQ(genetic.population, 12);
  EXPECT_EQ(genetic.offspring, 4);
  EXPECT_EQ(genetic.generations, 6);
  EXPECT_EQ(genetic.tournament, 3);
  EXPECT_EQ(genetic.crossover, 0.3);
  EXPECT_EQ(genetic.mutation, 0.1);
  EXPECT_EQ(genetic.step, 0.2);
  EXPECT_EQ(genetic.overlap_cost, 2);
  EXPECT_EQ(genetic.hyperbolic_cost, 3);
  EXPECT_EQ(genetic.seed, 8u);
  const ExchangeTask exchange = std::get<ExchangeTask>(carried(3));
  EXPECT_EQ(exchange.parts.labels.size(), 11u);
  EXPECT_EQ(exchange.parts.fold_edges, (std::vector<int>{2, 3, 5, 6}));
  EXPECT_EQ(exchange.parts.shortfalls, (std::map<int, int>{{0, 1}}));
  EXPECT_EQ(exchange.options.most_steps, 40);
  EXPECT_EQ(exchange.options.most_moves, 100000);
  EXPECT_EQ(exchange.options.temperature, 0.9);
  EXPECT_EQ(exchange.options.clearance, 0.03);
  EXPECT_EQ(exchange.options.seed, 6u);
  const PlanTask plan = std::get<PlanTask>(carried(4));
  EXPECT_EQ(plan.folds, (FoldTree{0, 1, 2, 3, 4, 5, 6, 8, 9, 10}));
  EXPECT_EQ(plan.clearance, 0.04);
  EXPECT_EQ(plan.seed, 10u);
}

TEST(Wire, CarriesTheMakingOfRoom) {
  const auto surface = make_surface(2, bumpy_sphere(60));
  const std::vector<int> panels = [&] {
    std::vector<int> all(surface->graph.panel_count());
    std::iota(all.begin(), all.end(), 0);
    return all;
  }();
  const SearchTask search{{.clearance = 0.02}};
  const auto net = std::get<SearchResult>(run({0, surface, panels, search}));
  ASSERT_TRUE(net.folds_straight);
  const Task task = {1, surface, panels, compact_task(net.folds)};
  const Task carried = decode_task(encode(task), decode_surface(encode(*surface)));
  const Bytes result = encode(run(task));
  EXPECT_EQ(encode(run(carried)), result);
  EXPECT_EQ(encode(decode_result(result)), result);
}

TEST(Wire, CarriesEveryOptionOfTheMakingOfRoom) {
  const auto surface = make_surface(0, cube());
  const Task task = {0, surface, {0}, compact_task({1, 2})};
  const auto compact = std::get<CompactTask>(decode_task(encode(task), surface).work);
  EXPECT_EQ(compact.folds, (FoldTree{1, 2}));
  EXPECT_EQ(compact.craft.scale, 12);
  EXPECT_EQ(compact.craft.shape.height, 4);
  EXPECT_EQ(compact.craft.shape.least, 1.5);
  EXPECT_EQ(compact.craft.shape.angles, (std::array{0.9, 0.8}));
  EXPECT_EQ(compact.craft.weights.flaps, 1.1);
  EXPECT_EQ(compact.craft.weights.hull, 2);
  EXPECT_EQ(compact.craft.weights.necks, 0.4);
  EXPECT_EQ(compact.craft.weights.excess, 0.7);
  EXPECT_EQ(compact.craft.room.width, 150);
  EXPECT_EQ(compact.craft.room.height, 200);
  ASSERT_EQ(compact.craft.borders.size(), 1u);
  EXPECT_EQ(compact.craft.borders[0].mesh_edge, 3);
  EXPECT_EQ(compact.craft.borders[0].height, 2.5);
  EXPECT_EQ(compact.annealing.work, 5000);
  EXPECT_EQ(compact.annealing.hot, 0.2);
  EXPECT_EQ(compact.annealing.cold, 0.03);
  EXPECT_EQ(compact.annealing.clearance, 0.02);
  EXPECT_EQ(compact.annealing.seed, 12u);
}

TEST(Wire, CarriesSurfaces) {
  const auto surface = make_surface(3, star());
  const auto copy = decode_surface(encode(*surface));
  EXPECT_EQ(copy->key, 3);
  EXPECT_EQ(copy->mesh.faces, surface->mesh.faces);
  EXPECT_EQ(copy->mesh.source_faces, surface->mesh.source_faces);
  ASSERT_EQ(copy->mesh.positions.size(), surface->mesh.positions.size());
  for (std::size_t i = 0; i < copy->mesh.positions.size(); ++i) {
    EXPECT_EQ(copy->mesh.positions[i], surface->mesh.positions[i]);
  }
  EXPECT_EQ(copy->graph.hinge_count(), surface->graph.hinge_count());
}

TEST(Wire, CarriesStatus) {
  const TaskStatus status = {
      0.25, 17, {{-3, 3, 0}, {-12, 2, 1}}, NetPicture{{1, 2, 3, 4, 5, 6}, {9}, {1}}};
  const TaskStatus copy = decode_status(encode(status));
  EXPECT_EQ(copy.progress, 0.25);
  EXPECT_EQ(copy.runs, 17);
  ASSERT_EQ(copy.generations.size(), 2u);
  EXPECT_EQ(copy.generations[1].best, -12);
  EXPECT_EQ(copy.generations[1].overlaps, 2);
  EXPECT_EQ(copy.generations[1].hyperbolic, 1);
  ASSERT_TRUE(copy.net);
  EXPECT_EQ(copy.net->corners, status.net->corners);
  EXPECT_EQ(copy.net->sources, status.net->sources);
  EXPECT_EQ(copy.net->overlapping, status.net->overlapping);
  EXPECT_FALSE(decode_status(encode(TaskStatus{})).net);
}

TEST(Wire, CarriesEveryFieldOfASearchAndAPlan) {
  const TaskResult found = SearchResult{{3, 4}, 5, 6, true, 7, 8};
  const auto search = std::get<SearchResult>(decode_result(encode(found)));
  EXPECT_EQ(search.folds, (FoldTree{3, 4}));
  EXPECT_EQ(search.overlaps, 5);
  EXPECT_EQ(search.shortfall, 6);
  EXPECT_TRUE(search.folds_straight);
  EXPECT_EQ(search.moves, 7);
  EXPECT_EQ(search.generations, 8);
  const TaskResult planned = PlanResult{motion_over({{0, 0}, {0.25, 1}, {1, 1}})};
  const FoldMotion motion = std::get<PlanResult>(decode_result(encode(planned))).motion;
  EXPECT_EQ(motion.kind, Folding::kWaypoints);
  EXPECT_EQ(motion.times, (std::vector<double>{0, 0.5, 1}));
  EXPECT_EQ(motion.shares, (std::vector<std::vector<double>>{{0, 0}, {0.25, 1}, {1, 1}}));
}

TEST(Wire, CarriesEveryFieldOfAnExchange) {
  const TaskResult result = ExchangeResult{true, {0, 1, 1}, {{1, {4, 5}}}, {{0, 2}}, 99};
  const auto copy = std::get<ExchangeResult>(decode_result(encode(result)));
  EXPECT_TRUE(copy.found);
  EXPECT_EQ(copy.labels, (std::vector<int>{0, 1, 1}));
  EXPECT_EQ(copy.changed, (std::map<int, FoldTree>{{1, {4, 5}}}));
  EXPECT_EQ(copy.shortfalls, (std::map<int, int>{{0, 2}}));
  EXPECT_EQ(copy.moves, 99);
}

}  // namespace
}  // namespace foldwright::testing
