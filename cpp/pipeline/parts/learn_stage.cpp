#include <algorithm>
#include <numeric>

#include "pipeline/parts/learning.h"
#include "pipeline/parts/matrix_picture.h"
#include "pipeline/sheets/model_size.h"

namespace foldwright {
namespace {

/// A component that stays whole, or is tried whole first, needs no learning, if that is not too
/// large for a sheet.
bool needs_learning(const JobState& state, const Component& component) {
  if (component.graph.panel_count() == 1 || component.equal_to) return false;
  if (component.parts > 0) return component.parts > 1;
  const std::vector<double>& areas = component.graph.areas;
  return !component.whole_first ||
         std::accumulate(areas.begin(), areas.end(), 0.0) >
             largest_part_area(state.model.surface->mesh, state.options.paper);
}

/// Learns the foldability of every component that will be clustered [paper, 4.1].
class LearnStage : public Stage {
 public:
  StageId id() const override { return StageId::kLearn; }

  void begin(JobState& state, TaskQueue& queue, Events&) override {
    for (int c = 0; c < static_cast<int>(state.parts.components.size()); ++c) {
      if (needs_learning(state, state.parts.components[c]))
        learnings_.emplace_back(state, c, queue);
    }
    runs_wanted_ = state.options.parts.runs * static_cast<int>(learnings_.size());
  }

  void complete(JobState& state, TaskQueue&, CompletedTask done, Events& events) override {
    const auto& counts = std::get<FoldabilityCounts>(done.result);
    runs_done_ += counts.runs;
    const auto learning = std::find_if(learnings_.begin(), learnings_.end(),
                                       [&](const Learning& l) { return l.owns(done.id); });
    const bool all = learning->complete(counts);
    LearnedEvent event{runs_done_, runs_wanted_};
    if (learning == learnings_.begin()) {
      event.matrix = make_matrix_picture(to_matrix(learning->counts()));
    }
    events.push_back(std::move(event));
    if (all) state.parts.components[learning->component()].learned = learning->finish();
  }

  void watch(int, const Running& running, Events& events) override {
    events.push_back(LearnedEvent{runs_so_far(running), runs_wanted_});
  }

  double progress(const JobState&, const Running& running) const override {
    if (runs_wanted_ == 0) return 1;
    return static_cast<double>(runs_so_far(running)) / runs_wanted_;
  }

 private:
  int runs_so_far(const Running& running) const {
    int runs = runs_done_;
    for (const auto& [task, status] : running) runs += status.runs;
    return runs;
  }

  std::vector<Learning> learnings_;
  int runs_wanted_ = 0;
  int runs_done_ = 0;
};

}  // namespace

std::unique_ptr<Stage> make_learn_stage() { return std::make_unique<LearnStage>(); }

}  // namespace foldwright
