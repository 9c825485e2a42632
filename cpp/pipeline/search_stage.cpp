#include <algorithm>
#include <array>
#include <map>

#include "pipeline/learning.h"

namespace foldwright {
namespace {

constexpr std::uint64_t kStage = 3;  // names the net search in task_seed

// Seeds that a region gets before it counts as having no net. Regions with a net almost always
// show it within three; the rest are pockets of negative curvature, which no seed helps.
constexpr int kAttempts = 12;

// Temperatures of the attempts in turn: 2 solves nearly all, rare tight regions want less.
constexpr std::array<double, 4> kTemperatures = {2, 1, 3, 0.5};

/// A region in search of a net, and the attempt that runs.
struct Search {
  Region region;
  std::uint64_t key = 0;  ///< names the region in its seeds
  int attempt = 0;
};

std::vector<Region> regions_of(const JobState& state) {
  std::vector<Region> regions;
  int first_part = 0;
  for (int c = 0; c < static_cast<int>(state.components.size()); ++c) {
    const Component& component = state.components[c];
    const int count = part_count(component.labels);
    for (int part = 0; part < count; ++part) {
      regions.push_back({c, first_part + part, Cause::kPart, {}});
    }
    for (int panel = 0; panel < component.graph.panel_count(); ++panel) {
      regions[first_part + component.labels[panel]].panels.push_back(panel);
    }
    first_part += count;
  }
  return regions;
}

/// Finds a net for every part; a part that has none is split with what was learned, recursively
/// [paper, 4.3].
class SearchStage : public Stage {
 public:
  StageId id() const override { return StageId::kSearch; }

  void begin(JobState& state, TaskQueue& queue, Events&) override {
    for (Region& region : regions_of(state)) start(state, queue, std::move(region));
  }

  void complete(JobState& state, TaskQueue& queue, int task, TaskResult result,
                Events& events) override {
    if (auto* counts = std::get_if<FoldabilityCounts>(&result)) {
      learned(state, queue, task, *counts);
    } else {
      searched(state, queue, task, std::get<SearchResult>(result), events);
    }
  }

  void end(JobState& state, Events&) override {
    // In the order of parts, and within a part by lowest panel, however the searches ended.
    std::sort(state.nets.begin(), state.nets.end(), [](const FoundNet& a, const FoundNet& b) {
      return std::pair(a.region.part, a.region.panels[0]) <
             std::pair(b.region.part, b.region.panels[0]);
    });
    note_splits(state);
  }

  void watch(const JobState&, const TaskRunner& running, Events& events) override {
    const auto search = searches_.find(running.task().id);
    if (search == searches_.end()) return;
    events.push_back(GenerationEvent{search->second.region.part, ++batches_,
                                     -static_cast<double>(running.overlaps()), running.overlaps()});
  }

  double progress(const JobState& state, const TaskRunner*) const override {
    const int all = state.surface->graph.panel_count();
    return static_cast<double>(panels_done_) / all;
  }

 private:
  void start(const JobState& state, TaskQueue& queue, Region region) {
    queue_attempt(state, queue, {std::move(region), next_key_++, 0});
  }

  void queue_attempt(const JobState& state, TaskQueue& queue, Search search) {
    TreeSearchOptions options;
    options.temperature = kTemperatures[search.attempt % kTemperatures.size()];
    options.seed = task_seed(state.options.seed, kStage, search.key,
                             static_cast<std::uint64_t>(search.attempt));
    std::vector<int> panels;
    for (const int panel : search.region.panels) {
      panels.push_back(state.components[search.region.component].panels[panel]);
    }
    const int id = queue.add(state.surface, std::move(panels), SearchTask{options});
    searches_.emplace(id, std::move(search));
  }

  void searched(JobState& state, TaskQueue& queue, int task, const SearchResult& result,
                Events& events) {
    Search search = std::move(searches_.at(task));
    searches_.erase(task);
    state.moves += result.moves;
    if (result.overlaps == 0) {
      panels_done_ += static_cast<int>(search.region.panels.size());
      events.push_back(NetEvent{search.region.part, static_cast<int>(state.nets.size())});
      state.nets.push_back({std::move(search.region), result.folds});
    } else if (++search.attempt < kAttempts) {
      queue_attempt(state, queue, std::move(search));
    } else {
      split(state, queue, std::move(search.region));
    }
  }

  /// Splits a region, once its component has been learned.
  void split(JobState& state, TaskQueue& queue, Region region) {
    const int component = region.component;
    if (!state.components[component].learned) {
      const bool asked = std::any_of(learnings_.begin(), learnings_.end(),
                                     [&](const Learning& l) { return l.component() == component; });
      if (!asked) learnings_.emplace_back(state, component, queue);
      waiting_.push_back(std::move(region));
      return;
    }
    const Component& of = state.components[component];
    std::vector<int> rows;
    for (const int panel : region.panels) rows.push_back(of.learned->rows[panel]);
    const Labels halves = split_in_two(state.surface->mesh, restrict_to(of.graph, region.panels),
                                       {of.learned->matrix, rows});
    for (const int half : {0, 1}) {
      Region share{component, region.part, Cause::kNoNet, {}};
      for (std::size_t i = 0; i < region.panels.size(); ++i) {
        if (halves[i] == half) share.panels.push_back(region.panels[i]);
      }
      start(state, queue, std::move(share));
    }
  }

  void learned(JobState& state, TaskQueue& queue, int task, const FoldabilityCounts& counts) {
    const auto learning = std::find_if(learnings_.begin(), learnings_.end(),
                                       [&](const Learning& l) { return l.owns(task); });
    if (!learning->complete(counts)) return;
    const int component = learning->component();
    state.components[component].learned = learning->finish();
    std::vector<Region> waiting = std::move(waiting_);
    waiting_.clear();
    for (Region& region : waiting) split(state, queue, std::move(region));
  }

  static void note_splits(JobState& state) {
    std::map<int, int> pieces_of_part;
    for (const FoundNet& net : state.nets) ++pieces_of_part[net.region.part];
    for (const auto& [part, pieces] : pieces_of_part) {
      if (pieces == 1) continue;
      state.notices.push_back({"part-split", "part " + std::to_string(part + 1) +
                                                 " has no net in one piece and became " +
                                                 std::to_string(pieces) + " pieces"});
    }
  }

  std::map<int, Search> searches_;   ///< by task
  std::vector<Learning> learnings_;  ///< asked for only because a region must be split
  std::vector<Region> waiting_;      ///< regions to split once their component is learned
  std::uint64_t next_key_ = 0;
  int panels_done_ = 0;
  int batches_ = 0;
};

}  // namespace

std::unique_ptr<Stage> make_search_stage() { return std::make_unique<SearchStage>(); }

}  // namespace foldwright
