#include "pipeline/values/task.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>

#include "folding.h"
#include "meshes.h"
#include "parts.h"
#include "trees.h"

namespace foldwright::testing {
namespace {

constexpr std::int64_t kToTheEnd = std::numeric_limits<std::int64_t>::max();

Task whole_task(const std::shared_ptr<const Surface>& surface, Work work) {
  std::vector<int> panels(surface->graph.panel_count());
  std::iota(panels.begin(), panels.end(), 0);
  return {0, surface, std::move(panels), std::move(work)};
}

TaskResult run(Task task, std::int64_t slice = kToTheEnd) {
  TaskRunner runner(std::move(task));
  double progress = 0;
  while (!runner.step(slice)) {
    progress = runner.status(false).progress;
    EXPECT_GE(progress, 0);
    EXPECT_LE(progress, 1);
  }
  return runner.result();
}

TEST(Surface, KnowsItsKeyAndItsPanels) {
  const auto surface = make_surface(7, cube());
  EXPECT_EQ(surface->key, 7);
  EXPECT_EQ(surface->mesh.face_count(), 12);
  EXPECT_EQ(surface->graph.panel_count(), 6);
}

TEST(LearnTask, GivesTheSameWhetherItIsSplitOrNot) {
  const auto surface = make_surface(0, star());
  const LearnOptions options = {.runs = 50, .seed = 3};
  const auto learn = [&](int first, int last, std::int64_t slice) {
    return std::get<FoldabilityCounts>(
        run(whole_task(surface, LearnTask{options, first, last}), slice));
  };
  const FoldabilityCounts whole = learn(0, 50, kToTheEnd);
  EXPECT_EQ(whole.runs, 50);
  FoldabilityCounts sum;
  for (const int first : {40, 10, 0, 20, 30}) sum.add(learn(first, first + 10, 1));
  EXPECT_EQ(sum.runs, 50);
  EXPECT_EQ(sum.counts, whole.counts);
}

TEST(LearnTask, TellsItsRuns) {
  const auto surface = make_surface(0, star());
  TaskRunner runner(whole_task(surface, LearnTask{{.runs = 8}, 2, 6}));
  for (int runs = 1; runs <= 4; ++runs) {
    EXPECT_FALSE(runner.step(1));
    EXPECT_EQ(runner.status(true).runs, runs);
    EXPECT_DOUBLE_EQ(runner.status(true).progress, runs / 4.0);
    EXPECT_FALSE(runner.status(true).net);
  }
  EXPECT_TRUE(runner.step(1));
}

TEST(SearchTask, GivesANetOfItsPanels) {
  const auto surface = make_surface(0, torus(12, 7));
  std::vector<int> panels(surface->graph.panel_count() / 2);  // a bent tube
  std::iota(panels.begin(), panels.end(), 0);
  const DualGraph graph = restrict_to(surface->graph, panels);
  for (const Work& work : {Work(SearchTask{{.seed = 2}}), Work(GeneticTask{{.seed = 2}})}) {
    const Task task = {0, surface, panels, work};
    const auto result = std::get<SearchResult>(run(task));
    ASSERT_EQ(result.overlaps, 0);
    EXPECT_TRUE(is_net(surface->mesh, graph, result.folds));
    EXPECT_EQ(std::get<SearchResult>(run(task, 1)).folds, result.folds);
  }
}

TEST(SearchTask, SaysWhetherItsNetFolds) {
  const auto surface = make_surface(0, bumpy_sphere(120));
  const auto search = [&](double clearance) {
    return std::get<SearchResult>(
        run(whole_task(surface, SearchTask{{.clearance = clearance, .seed = 2}})));
  };
  const SearchResult any = search(0);
  EXPECT_EQ(any.overlaps, 0);
  EXPECT_EQ(any.shortfall, 0);
  EXPECT_FALSE(any.folds_straight) << "nobody looked";
  const SearchResult folding = search(kClearance);
  EXPECT_TRUE(folding.folds_straight);
  EXPECT_EQ(folding.shortfall, 0);
  const Foldable foldable = make_foldable(surface->graph);
  Certificate certificate(foldable, folding.folds, straight_leg(surface->graph));
  EXPECT_EQ(certificate.step(kToTheEnd), Certificate::State::kCertified);
}

TEST(SearchTask, SaysHowFarItIsFromANetThatFolds) {
  const auto surface = make_surface(0, crossing_strip());
  const auto result = std::get<SearchResult>(
      run(whole_task(surface, SearchTask{{.patience = 100, .clearance = kClearance}})));
  EXPECT_EQ(result.overlaps, 0);
  EXPECT_GT(result.shortfall, 0);
  EXPECT_FALSE(result.folds_straight);
}

TEST(SearchTask, StartsFromATreeThatIsGiven) {
  const auto surface = make_surface(0, cube());
  const DualGraph& graph = surface->graph;
  const FoldTree net = all_spanning_trees(graph)[100];
  ASSERT_TRUE(is_net(surface->mesh, graph, net));
  EXPECT_EQ(std::get<SearchResult>(run(whole_task(surface, SearchTask{{}, net}))).folds, net);
}

TEST(SearchTask, TellsWhenItIsAboutFolding) {
  const auto surface = make_surface(0, bumpy_sphere(120));
  const auto folding_steps = [&](double clearance) {
    TaskRunner runner(whole_task(surface, SearchTask{{.clearance = clearance, .seed = 2}}));
    EXPECT_FALSE(runner.is_folding()) << "before there is a net";
    int steps = 0;
    bool done = false;
    while (!done) {
      steps += runner.is_folding();
      done = runner.step(100);
    }
    return steps;
  };
  EXPECT_EQ(folding_steps(0), 0);
  EXPECT_GT(folding_steps(kClearance), 0);
  const auto plain = make_surface(0, cube());
  const PlanTask plan = {all_spanning_trees(plain->graph)[0], kClearance, 1};
  EXPECT_TRUE(TaskRunner(whole_task(plain, plan)).is_folding());
}

TEST(PlanTask, FoldsANetOfItsPanels) {
  const auto surface = make_surface(0, bumpy_sphere(80));
  const DualGraph& graph = surface->graph;
  const FoldTree folds = net_that_does_not_fold_straight(surface->mesh, graph, 10);
  ASSERT_FALSE(folds.empty());
  const Task task = whole_task(surface, PlanTask{folds, kClearance, 4});
  const FoldMotion motion = std::get<PlanResult>(run(task)).motion;
  EXPECT_EQ(motion.kind, Folding::kWaypoints);
  const PlainFolder folder(surface->mesh, graph, folds);
  EXPECT_TRUE(colliding_times(folder, graph, folds, motion, 300).empty());
  EXPECT_EQ(std::get<PlanResult>(run(task, 1000)).motion.shares, motion.shares);
}

TEST(PlanTask, HasNoNetToShow) {
  const auto surface = make_surface(0, cube());
  TaskRunner runner(whole_task(surface, PlanTask{all_spanning_trees(surface->graph)[0], 0.01, 1}));
  const TaskStatus status = runner.status(true);
  EXPECT_FALSE(status.net);
  EXPECT_TRUE(status.generations.empty());
  EXPECT_EQ(status.progress, 0);
}

TEST(SearchTask, ShowsItsBestTree) {
  const auto surface = make_surface(0, bumpy_sphere(300));
  TaskRunner runner(whole_task(surface, SearchTask{{.starts = 1, .seed = 2}}));
  std::vector<double> best;
  while (!runner.step(500)) {
    const TaskStatus status = runner.status(true);
    for (const SearchStatus& generation : status.generations) best.push_back(generation.best);
    if (!status.net) continue;
    const auto faces = surface->mesh.faces.size();
    EXPECT_EQ(status.net->corners.size(), 6 * faces);
    EXPECT_EQ(status.net->sources.size(), faces);
    EXPECT_EQ(status.net->overlapping.size(), faces);
    EXPECT_FALSE(runner.status(false).net);
  }
  for (const SearchStatus& generation : runner.status(false).generations) {
    best.push_back(generation.best);
  }
  EXPECT_TRUE(std::ranges::is_sorted(best)) << "the best fitness fell";
  ASSERT_FALSE(best.empty());
  EXPECT_EQ(best.back(), 0) << "the net did not show as a generation";
}

TEST(ExchangeTask, CuresAPart) {
  const auto surface = make_surface(0, saddle_with_apron(7, 3));
  PartsSoFar parts{{}, {}, {{0, 1}}};
  for (int panel = 0; panel < surface->graph.panel_count(); ++panel) {
    parts.labels.push_back(surface->graph.panel_faces(panel)[0] < 8 ? 0 : 1);
  }
  const Task task = whole_task(surface, ExchangeTask{parts, {}});
  const auto result = std::get<ExchangeResult>(run(task));
  EXPECT_TRUE(result.found);
  EXPECT_EQ(part_count(result.labels), 2);
  for (const auto& [part, folds] : result.changed) {
    const DualGraph graph = restrict_to(surface->graph, panels_of(result.labels, part));
    EXPECT_TRUE(is_net(surface->mesh, graph, folds));
  }
  EXPECT_EQ(result.changed.size(), 2u);
  EXPECT_EQ(std::get<ExchangeResult>(run(task, 1)).labels, result.labels);
}

}  // namespace
}  // namespace foldwright::testing
