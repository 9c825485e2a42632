#include "pipeline/nets/spare_nets.h"

#include <gtest/gtest.h>

#include <numeric>
#include <set>

#include "job_runs.h"
#include "meshes.h"
#include "pipeline/job.h"

namespace foldwright::testing {
namespace {

/// A strip of eight panels, of which the first half is part 0 and the second half part 1.
JobState state_of_strip() {
  JobState state;
  state.model.surface = make_surface(kModelSurface, accordion(std::vector<double>(8, 1)));
  const DualGraph& graph = state.model.surface->graph;
  Component component;
  component.graph = graph;
  component.panels.resize(graph.panel_count());
  std::iota(component.panels.begin(), component.panels.end(), 0);
  for (int panel = 0; panel < graph.panel_count(); ++panel) {
    component.labels.push_back(2 * panel < graph.panel_count() ? 0 : 1);
  }
  component.part_numbers = {0, 1};
  state.parts.components.push_back(std::move(component));
  return state;
}

FoundNet net_of(int part, std::vector<int> panels) {
  return {{.part = part, .panels = std::move(panels)}, {}, {}};
}

TEST(SpareNets, AreTakenWhereNoPanelHasANet) {
  JobState state = state_of_strip();
  state.nets.found.push_back(net_of(0, {0, 1, 2}));
  add_spare_nets(state, {net_of(1, {2, 3, 4}), net_of(1, {3, 4, 5}), net_of(0, {5, 6})});
  ASSERT_EQ(state.nets.found.size(), 2u);
  EXPECT_EQ(state.nets.found[1].region.panels, (std::vector{3, 4, 5}));
}

TEST(SpareNets, GiveTheirPanelsTheirPart) {
  JobState state = state_of_strip();
  add_spare_nets(state, {net_of(1, {0, 1}), net_of(7, {2})});
  EXPECT_EQ(state.nets.found.size(), 1u) << "no component has a part 7";
  EXPECT_EQ(std::vector(state.parts.components[0].labels.begin(),
                        state.parts.components[0].labels.begin() + 3),
            (std::vector{1, 1, 0}));
}

/// Runs a job for so many steps, or until all nets are found, and cancels it: every part whose net
/// was told must be handed over. Whether all were found.
bool hands_over_after(int steps) {
  JobOptions options;
  options.parts.count = 3;
  options.parts.runs = 10;
  Job job({{"hills.obj", to_bytes(obj_of(bumpy_sphere(300)))}}, options);
  std::set<int> told;
  for (int i = 0; i < steps; ++i) {
    for (const Event& event : job.step(kSlice)) {
      if (const auto* net = std::get_if<NetEvent>(&event)) told.insert(net->part);
      const auto* stage = std::get_if<StageEvent>(&event);
      if (stage && stage->stage == StageId::kCompact) return true;
    }
  }
  const Events last = job.cancel();
  const auto& best = std::get<CancelledEvent>(last.back()).best;
  std::set<int> handed_over;
  if (best) {
    for (const Piece& piece : best->pieces) handed_over.insert(piece.part);
  }
  EXPECT_GE(handed_over.size(), told.size()) << "after " << steps << " steps";
  return false;
}

// Between two stages, too, where the next one is announced but has not begun.
TEST(SpareNets, HandOverWhatEventsHaveToldWheneverAJobIsCancelled) {
  for (int steps = 1; !hands_over_after(steps); ++steps) {
  }
}

}  // namespace
}  // namespace foldwright::testing
