#include "pipeline/nets/part_trees.h"

#include <gtest/gtest.h>

#include <numeric>

#include "meshes.h"
#include "parts.h"
#include "trees.h"

namespace foldwright::testing {
namespace {

/// A job that has come to its search: a saddle and its apron as parts 0 and 1.
JobState state_before_search() {
  JobState state;
  state.model.surface = make_surface(kModelSurface, saddle_with_apron(7, 3));
  const DualGraph& graph = state.model.surface->graph;
  Component component;
  component.panels.resize(graph.panel_count());
  std::iota(component.panels.begin(), component.panels.end(), 0);
  component.graph = graph;
  for (int panel = 0; panel < graph.panel_count(); ++panel) {
    component.labels.push_back(graph.panel_faces(panel)[0] < 8 ? 0 : 1);
  }
  component.part_numbers = {0, 1};
  state.parts.components.push_back(std::move(component));
  state.parts.labels.resize(state.model.surface->mesh.faces.size());
  return state;
}

FoldTree any_tree(const JobState& state, const Region& region) {
  const DualGraph graph = restrict_to(state.parts.components[0].graph, region.panels);
  return minimum_spanning_tree(graph, std::vector<double>(graph.hinges.size(), 0));
}

TEST(PartTrees, KnowThePanelsOfEachPart) {
  JobState state = state_before_search();
  const PartTrees trees(state);
  EXPECT_EQ(trees.part_count(), 2);
  for (const int part : {0, 1}) {
    const Region region = trees.region(state, part);
    EXPECT_EQ(region.part, part);
    EXPECT_EQ(region.cause, Cause::kPart);
    EXPECT_EQ(region.panels, panels_of(state.parts.components[0].labels, part));
  }
  label_faces(state);
  for (int face = 0; face < state.model.surface->mesh.face_count(); ++face) {
    EXPECT_EQ(state.parts.labels[face], face < 8 ? 0 : 1);
  }
}

TEST(PartTrees, ExchangePartsOneByOneInTheirOrder) {
  JobState state = state_before_search();
  PartTrees trees(state);
  TaskQueue queue;
  EXPECT_FALSE(trees.begin_exchange(state, queue));
  for (const int part : {1, 0}) {
    const Region region = trees.region(state, part);
    trees.postpone(region, {any_tree(state, region), 1 - part, 1, {}});
  }
  for (const int part : {0, 1}) {
    ASSERT_TRUE(trees.begin_exchange(state, queue));
    EXPECT_TRUE(trees.exchanging());
    EXPECT_EQ(trees.exchanging_part(), part);
    const ExchangeTask task = std::get<ExchangeTask>(queue.take().work);
    EXPECT_EQ(task.options.part, part);
    // A part without a net is given any, one with a net one that folds.
    EXPECT_EQ(task.options.clearance > 0, part == 1);
    EXPECT_TRUE(trees.end_exchange(state, {false, {}, {}, {}, 5}).empty());
    EXPECT_FALSE(trees.exchanging());
  }
  // Of two parts none can be split in the other's stead.
  EXPECT_TRUE(trees.regroup_next(state).empty());
  EXPECT_FALSE(trees.begin_exchange(state, queue));
  const auto uncured = trees.take_uncured();
  ASSERT_EQ(uncured.size(), 2u);
  EXPECT_FALSE(uncured[0].second.is_net());
  EXPECT_TRUE(uncured[1].second.is_net());
  EXPECT_TRUE(trees.take_uncured().empty());
}

TEST(PartTrees, SearchAPartFarFromFoldingAgainWhereNoneCanBeSplitInstead) {
  JobState state = state_before_search();
  PartTrees trees(state);
  for (const int part : {0, 1}) {
    const Region region = trees.region(state, part);
    EXPECT_TRUE(trees.may_regroup(part));
    trees.postpone(region, {any_tree(state, region), 0, part == 0 ? 1000 : 1, {}});
  }
  const Labels before = state.parts.components[0].labels;
  EXPECT_EQ(trees.regroup_next(state), std::vector{0});
  EXPECT_EQ(state.parts.components[0].labels, before);
  EXPECT_FALSE(trees.may_regroup(0)) << "or it would be asked for again and again";
  EXPECT_TRUE(trees.regroup_next(state).empty());
}

TEST(PartTrees, KeepTheNetOfANeighbourThatStillDoesNotFold) {
  JobState state = state_before_search();
  PartTrees trees(state);
  TaskQueue queue;
  for (const int part : {0, 1}) {
    const Region region = trees.region(state, part);
    trees.postpone(region, {any_tree(state, region), 0, 3, {}});
  }
  ASSERT_TRUE(trees.begin_exchange(state, queue));
  // Part 1 lost a panel to part 0, and is a net that comes to two collisions.
  ExchangeResult result{true, state.parts.components[0].labels, {}, {{1, 2}}, 0};
  const DualGraph& graph = state.parts.components[0].graph;
  for (const Hinge& hinge : graph.hinges) {
    const auto [a, b] = hinge.panels;
    if (result.labels[a] == result.labels[b] || b != 8) continue;
    result.labels[b] = 0;
  }
  ASSERT_EQ(fault_of_parts(graph, result.labels), "");
  ASSERT_NE(result.labels, state.parts.components[0].labels);
  for (const int part : {0, 1}) {
    const DualGraph of = restrict_to(graph, panels_of(result.labels, part));
    result.changed[part] = minimum_spanning_tree(of, std::vector<double>(of.hinges.size(), 0));
  }
  const auto again = trees.end_exchange(state, result);
  ASSERT_EQ(again.size(), 1u);
  EXPECT_EQ(again[0].part, 0);
  EXPECT_EQ(state.parts.components[0].labels, result.labels);
  trees.collect(state);
  ASSERT_EQ(state.nets.found.size(), 1u) << "what does not fold is a net all the same";
  EXPECT_EQ(state.nets.found[0].region.part, 1);
}

}  // namespace
}  // namespace foldwright::testing
