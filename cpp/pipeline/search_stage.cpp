#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "pipeline/learning.h"

namespace foldwright {
namespace {

constexpr std::uint64_t kSearch = 3;    // names the net search in task_seed
constexpr std::uint64_t kExchange = 4;  // and the border exchange

// Temperatures of the attempts in turn: 2 solves nearly all, rare tight regions want less.
constexpr std::array<double, 4> kTemperatures = {2, 1, 3, 0.5};

// Seeds that a region gets before it counts as having no net. A part with a net almost always shows
// it at once, and one without is cured at its border. A whole component has no border.
constexpr int kAttemptsOfPart = 3;
constexpr int kAttemptsOfWhole = 12;

// An evolution and three restarts, as the paper's authors set it. What evolution does not solve is
// split, as published: border exchange belongs to the tree search.
constexpr int kEvolutions = 4;

// What a search under way counts for in the progress, against one that found its net.
constexpr double kSearchShare = 0.7;

/// A region in search of a net, and the attempt that runs.
struct Search {
  Region region;
  std::uint64_t key = 0;  ///< names the region in its seeds
  int attempt = 0;
};

/// Number of the first part of each component.
std::vector<int> first_parts(const JobState& state) {
  std::vector<int> first = {0};
  for (const Component& component : state.components) {
    first.push_back(first.back() + part_count(component.labels));
  }
  return first;
}

std::vector<int> panels_of(const Labels& labels, int part) {
  std::vector<int> panels;
  for (int panel = 0; panel < static_cast<int>(labels.size()); ++panel) {
    if (labels[panel] == part) panels.push_back(panel);
  }
  return panels;
}

/// Finds a net for every part. A part that has none first exchanges border panels with its
/// neighbours; if that does not help it is split with what was learned, recursively [paper, 4.3].
class SearchStage : public Stage {
 public:
  StageId id() const override { return StageId::kSearch; }

  void begin(JobState& state, TaskQueue& queue, Events&) override {
    first_part_ = first_parts(state);
    for (int c = 0; c < static_cast<int>(state.components.size()); ++c) {
      for (int part = first_part_[c]; part < first_part_[c + 1]; ++part) {
        start(state, queue, whole_part(state, c, part));
      }
    }
  }

  void complete(JobState& state, TaskQueue& queue, int task, TaskResult result,
                Events& events) override {
    if (auto* counts = std::get_if<FoldabilityCounts>(&result)) {
      learned(state, queue, task, *counts);
    } else if (auto* exchanged = std::get_if<ExchangeResult>(&result)) {
      this->exchanged(state, queue, *exchanged, events);
    } else {
      searched(state, queue, task, std::get<SearchResult>(result), events);
    }
    if (searches_.empty() && !exchanging_) next_exchange(state, queue);
  }

  void end(JobState& state, Events& events) override {
    salvage(state);
    if (labels_changed_) events.push_back(SegmentedEvent{state.result.labels});
    note_splits(state);
  }

  void salvage(JobState& state) override {
    label_faces(state);
    for (auto& [part, tree] : part_trees_) {
      if (tree.overlaps == 0) state.nets.push_back(std::move(tree.net));
    }
    part_trees_.clear();
    // In the order of parts, and within a part by lowest panel, however the searches ended.
    std::sort(state.nets.begin(), state.nets.end(), [](const FoundNet& a, const FoundNet& b) {
      return std::pair(a.region.part, a.region.panels[0]) <
             std::pair(b.region.part, b.region.panels[0]);
    });
  }

  void watch(int task, const Running& running, Events& events) override {
    int part = 0;
    if (const auto search = searches_.find(task); search != searches_.end()) {
      part = search->second.region.part;
    } else if (exchanging_) {
      part = exchanging_->part;
    } else {
      return;
    }
    const TaskStatus& status = running.at(task);
    for (const SearchStatus& generation : status.generations) {
      History& history = histories_[part];
      if (history.generations++ == 0 || generation.best > history.best.best) {
        history.best = generation;
      }
      const SearchStatus& best = history.best;
      events.push_back(GenerationEvent{part, history.generations, best.best, best.overlaps,
                                       best.hyperbolic, std::nullopt});
    }
    if (status.generations.empty() || !status.net) return;
    std::get<GenerationEvent>(events.back()).net = status.net;
  }

  double progress(const JobState& state, const Running& running) const override {
    double done = panels_done_;
    for (const auto& [task, status] : running) {
      const auto search = searches_.find(task);
      if (search == searches_.end()) continue;
      // A search that gives up starts over, so that its whole way counts for a part only.
      done +=
          kSearchShare * status.progress * static_cast<double>(search->second.region.panels.size());
    }
    return std::min(1.0, done / state.surface->graph.panel_count());
  }

 private:
  Region whole_part(const JobState& state, int component, int part) const {
    return {component, part, Cause::kPart,
            panels_of(state.components[component].labels, part - first_part_[component])};
  }

  /// The region itself names its searches in their seeds, since regions come up in any order.
  static std::uint64_t key_of(const Region& region) {
    std::uint64_t key = static_cast<std::uint64_t>(region.part);
    for (const int panel : region.panels) {
      key = task_seed(key, kSearch, static_cast<std::uint64_t>(panel), 0);
    }
    return key;
  }

  void start(const JobState& state, TaskQueue& queue, Region region) {
    const std::uint64_t key = key_of(region);
    queue_attempt(state, queue, {std::move(region), key, 0});
  }

  void queue_attempt(const JobState& state, TaskQueue& queue, Search search) {
    const std::uint64_t seed = task_seed(state.options.seed, kSearch, search.key,
                                         static_cast<std::uint64_t>(search.attempt));
    std::vector<int> panels;
    for (const int panel : search.region.panels) {
      panels.push_back(state.components[search.region.component].panels[panel]);
    }
    Work work;
    if (state.options.solver == Solver::kGenetic) {
      work = GeneticTask{{.seed = seed}};
    } else {
      const double temperature = kTemperatures[search.attempt % kTemperatures.size()];
      work = SearchTask{{.temperature = temperature, .seed = seed}};
    }
    const int id = queue.add(state.surface, std::move(panels), std::move(work));
    searches_.emplace(id, std::move(search));
  }

  /// Seeds that a region gets before it counts as having no net.
  static int attempts_for(const JobState& state, bool is_whole) {
    if (state.options.solver == Solver::kGenetic) return kEvolutions;
    return is_whole ? kAttemptsOfWhole : kAttemptsOfPart;
  }

  void searched(JobState& state, TaskQueue& queue, int task, const SearchResult& result,
                Events& events) {
    Search search = std::move(searches_.at(task));
    searches_.erase(task);
    state.moves += result.moves;
    state.generations += result.generations;
    const Region& region = search.region;
    const bool is_whole = region.panels.size() == state.components[region.component].panels.size();
    if (result.overlaps == 0) {
      panels_done_ += static_cast<int>(region.panels.size());
      found(state, std::move(search.region), result.folds, events);
    } else if (++search.attempt < attempts_for(state, is_whole)) {
      queue_attempt(state, queue, std::move(search));
    } else if (region.cause == Cause::kPart && !is_whole && state.options.solver == Solver::kTree) {
      // Exchanges wait until all parts have been tried, and then go in the order of parts: each
      // changes the borders that the next one sees.
      without_net_.insert(region.part);
      const int part = region.part;
      part_trees_[part] = {{std::move(search.region), result.folds}, result.overlaps};
    } else {
      split(state, queue, std::move(search.region));
    }
  }

  void found(JobState& state, Region region, const FoldTree& folds, Events& events) {
    events.push_back(NetEvent{region.part, nets_found_++});
    if (region.cause == Cause::kPart) {
      const int part = region.part;
      part_trees_[part] = {{std::move(region), folds}, 0};
    } else {
      state.nets.push_back({std::move(region), folds});
    }
  }

  int component_of(int part) const {
    const auto above = std::upper_bound(first_part_.begin(), first_part_.end(), part);
    return static_cast<int>(above - first_part_.begin()) - 1;
  }

  void next_exchange(const JobState& state, TaskQueue& queue) {
    if (without_net_.empty()) return;
    const int part = *without_net_.begin();
    without_net_.erase(without_net_.begin());
    const int component = component_of(part);
    ExchangeTask task{parts_so_far(state, component), {}};
    task.options.part = part - first_part_[component];
    task.options.seed =
        task_seed(state.options.seed, kExchange, static_cast<std::uint64_t>(part), 0);
    queue.add(state.surface, state.components[component].panels, std::move(task));
    exchanging_ = {component, part};
  }

  PartsSoFar parts_so_far(const JobState& state, int component) const {
    PartsSoFar parts{state.components[component].labels, {}, {}};
    for (int part = first_part_[component]; part < first_part_[component + 1]; ++part) {
      const PartTree& tree = part_trees_.at(part);
      const DualGraph graph =
          restrict_to(state.components[component].graph, tree.net.region.panels);
      for (const int h : tree.net.folds) parts.fold_edges.push_back(graph.hinges[h].edges[0]);
      if (tree.overlaps > 0) parts.overlaps[part - first_part_[component]] = tree.overlaps;
    }
    return parts;
  }

  void exchanged(JobState& state, TaskQueue& queue, const ExchangeResult& result, Events& events) {
    const auto [component, part] = *exchanging_;
    exchanging_.reset();
    state.moves += result.moves;
    if (result.found) {
      labels_changed_ = true;
      state.components[component].labels = result.labels;
      for (const auto& [changed, folds] : result.changed) {
        const int of = first_part_[component] + changed;
        const auto left = result.overlaps.find(changed);
        const int overlaps = of == part || left == result.overlaps.end() ? 0 : left->second;
        part_trees_[of] = {{whole_part(state, component, of), folds}, overlaps};
        // A neighbour may have come to its own net on the way.
        if (overlaps == 0) without_net_.erase(of);
      }
      panels_done_ += static_cast<int>(part_trees_[part].net.region.panels.size());
      events.push_back(NetEvent{part, nets_found_++});
    } else {
      uncured_.push_back(part);
    }
    if (without_net_.empty()) split_rest(state, queue);
  }

  /// After the last exchange borders stand still: what still has no net is split.
  void split_rest(JobState& state, TaskQueue& queue) {
    const std::vector<int> parts = std::move(uncured_);
    uncured_.clear();
    for (const int part : parts) {
      // A later exchange with this part as the neighbour may have cured it.
      if (part_trees_.at(part).overlaps == 0) continue;
      part_trees_.erase(part);
      Region region = whole_part(state, component_of(part), part);
      region.cause = Cause::kNoNet;
      split(state, queue, std::move(region));
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

  void label_faces(JobState& state) const {
    for (std::size_t c = 0; c < state.components.size(); ++c) {
      const Component& component = state.components[c];
      for (int panel = 0; panel < component.graph.panel_count(); ++panel) {
        for (const int face : component.graph.panel_faces(panel)) {
          state.result.labels[face] = first_part_[c] + component.labels[panel];
        }
      }
    }
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

  /// Component and part of the border exchange under way.
  struct Exchanging {
    int component, part;
  };
  /// The best tree of a whole part; a net if `overlaps` is 0.
  struct PartTree {
    FoundNet net;
    int overlaps = 0;
  };

  /// What events tell of a part's searches, one after the other.
  struct History {
    int generations = 0;
    SearchStatus best{};
  };

  std::vector<int> first_part_;
  std::map<int, History> histories_;    ///< by part
  std::map<int, Search> searches_;      ///< by task
  std::map<int, PartTree> part_trees_;  ///< by part: an exchange may replace them
  std::set<int> without_net_;           ///< parts whose exchange is to come
  std::optional<Exchanging> exchanging_;
  std::vector<int> uncured_;         ///< parts that their exchange did not cure
  std::vector<Learning> learnings_;  ///< asked for only because a region must be split
  std::vector<Region> waiting_;      ///< regions to split once their component is learned
  int panels_done_ = 0;
  int nets_found_ = 0;
  bool labels_changed_ = false;
};

}  // namespace

std::unique_ptr<Stage> make_search_stage() { return std::make_unique<SearchStage>(); }

}  // namespace foldwright
