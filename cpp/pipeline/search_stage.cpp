#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

#include "pipeline/learning.h"
#include "pipeline/search_history.h"

namespace foldwright {
namespace {

constexpr std::uint64_t kSearch = 3;    // names the net search in task_seed
constexpr std::uint64_t kExchange = 4;  // the border exchange
constexpr std::uint64_t kPlan = 5;      // and the planning of a motion

// Temperatures of the attempts in turn: 2 solves nearly all, rare tight regions want less.
constexpr std::array<double, 4> kTemperatures = {2, 1, 3, 0.5};

// Seeds that a region gets before it counts as having no net that folds. A part with one almost
// always shows it at once, and one without is cured at its border. A whole component has no border.
constexpr int kAttemptsOfPart = 3;
constexpr int kAttemptsOfWhole = 12;

// An evolution and three restarts, as the paper's authors set it. What evolution does not solve is
// split, as published: border exchange belongs to the tree search.
constexpr int kEvolutions = 4;

// What a search under way counts for in the progress, against one that found its net.
constexpr double kSearchShare = 0.7;

/// The best tree of a region so far.
struct Candidate {
  FoldTree folds;
  int overlaps = -1;  ///< -1: there is none yet
  int shortfall = 0;  ///< see `SearchResult`
  FoldMotion motion;

  bool is_net() const { return overlaps == 0; }
};

/// A region in search of a net, and the attempt that runs.
struct Search {
  Region region;
  std::uint64_t key = 0;  ///< names the region in its seeds
  int attempt = 0;
  Candidate best;
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

/// The region itself names its searches in their seeds, since regions come up in any order.
std::uint64_t key_of(const Region& region) {
  std::uint64_t key = static_cast<std::uint64_t>(region.part);
  for (const int panel : region.panels) {
    key = task_seed(key, kSearch, static_cast<std::uint64_t>(panel), 0);
  }
  return key;
}

/// Finds a net for every part, and a motion that folds it up. What has none first exchanges border
/// panels with its neighbours; if that does not help it is split with what was learned, recursively
/// [paper, 4.3, 4.4].
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
    } else if (auto* planned = std::get_if<PlanResult>(&result)) {
      this->planned(state, queue, task, *planned, events);
    } else {
      searched(state, queue, task, std::get<SearchResult>(result), events);
    }
    if (searches_.empty() && !exchanging_) next_exchange(state, queue);
  }

  void end(JobState& state, Events& events) override {
    salvage(state);
    if (labels_changed_) events.push_back(SegmentedEvent{state.result.labels});
    note_outcome(state);
  }

  void salvage(JobState& state) override {
    label_faces(state);
    for (auto& [part, tree] : part_trees_) {
      if (tree.is_net) state.nets.push_back(std::move(tree.net));
    }
    part_trees_.clear();
    // In the order of parts, and within a part by lowest panel, however the searches ended.
    std::sort(state.nets.begin(), state.nets.end(), [](const FoundNet& a, const FoundNet& b) {
      return std::pair(a.region.part, a.region.panels[0]) <
             std::pair(b.region.part, b.region.panels[0]);
    });
  }

  void watch(int task, const Running& running, Events& events) override {
    if (const auto search = searches_.find(task); search != searches_.end()) {
      history_.tell(search->second.region.part, running.at(task), events);
    } else if (exchanging_) {
      history_.tell(exchanging_->part, running.at(task), events);
    }
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

  static bool wants_motion(const JobState& state, const Region& region) {
    return state.options.folding != FoldingMode::kOff && !region.meets_itself;
  }

  /// Seeds that a region gets before it counts as having no net.
  static int attempts_for(const JobState& state, const Region& region) {
    if (state.options.solver == Solver::kGenetic) return kEvolutions;
    return is_component(state, region) ? kAttemptsOfWhole : kAttemptsOfPart;
  }

  static bool is_component(const JobState& state, const Region& region) {
    return region.panels.size() == state.components[region.component].panels.size();
  }

  void start(const JobState& state, TaskQueue& queue, Region region) {
    if (state.options.folding != FoldingMode::kOff) {
      const DualGraph graph = restrict_to(state.components[region.component].graph, region.panels);
      region.meets_itself = meets_itself(make_foldable(graph, state.options.clearance));
    }
    const std::uint64_t key = key_of(region);
    queue_attempt(state, queue, {std::move(region), key, 0, {}});
  }

  void queue_attempt(const JobState& state, TaskQueue& queue, Search search) {
    const std::uint64_t seed = task_seed(state.options.seed, kSearch, search.key,
                                         static_cast<std::uint64_t>(search.attempt));
    if (state.options.solver == Solver::kGenetic) {
      queue_work(state, queue, std::move(search), GeneticTask{{.seed = seed}});
      return;
    }
    const double clearance = wants_motion(state, search.region) ? state.options.clearance : 0;
    const double temperature = kTemperatures[search.attempt % kTemperatures.size()];
    queue_work(state, queue, std::move(search),
               SearchTask{{.temperature = temperature, .clearance = clearance, .seed = seed}});
  }

  void queue_work(const JobState& state, TaskQueue& queue, Search search, Work work) {
    std::vector<int> panels;
    for (const int panel : search.region.panels) {
      panels.push_back(state.components[search.region.component].panels[panel]);
    }
    const int id = queue.add(state.surface, std::move(panels), std::move(work));
    searches_.emplace(id, std::move(search));
  }

  Search take_search(int task) {
    Search search = std::move(searches_.at(task));
    searches_.erase(task);
    return search;
  }

  void searched(JobState& state, TaskQueue& queue, int task, const SearchResult& result,
                Events& events) {
    Search search = take_search(task);
    state.moves += result.moves;
    state.generations += result.generations;
    Candidate& best = search.best;
    if (best.overlaps == -1 ||
        std::pair(result.overlaps, result.shortfall) < std::pair(best.overlaps, best.shortfall)) {
      best = {result.folds, result.overlaps, result.shortfall, {}};
      if (result.folds_straight) best.motion = straight_motion(best.folds);
    }
    const bool wants = wants_motion(state, search.region);
    if (best.is_net() && (!wants || best.motion.certified())) {
      settle(state, std::move(search), events);
    } else if (best.is_net() && state.options.solver == Solver::kGenetic) {
      plan(state, queue, std::move(search));
    } else if (++search.attempt < attempts_for(state, search.region)) {
      queue_attempt(state, queue, std::move(search));
    } else if (best.is_net()) {
      plan(state, queue, std::move(search));
    } else {
      unsolved(state, queue, std::move(search), events);
    }
  }

  /// Looks for a motion of a net that does not fold straight.
  void plan(const JobState& state, TaskQueue& queue, Search search) {
    const std::uint64_t seed = task_seed(state.options.seed, kPlan, search.key, 0);
    PlanTask task{search.best.folds, state.options.clearance, seed};
    queue_work(state, queue, std::move(search), std::move(task));
  }

  void planned(JobState& state, TaskQueue& queue, int task, const PlanResult& result,
               Events& events) {
    Search search = take_search(task);
    search.best.motion = result.motion;
    if (result.motion.certified()) {
      settle(state, std::move(search), events);
    } else {
      unsolved(state, queue, std::move(search), events);
    }
  }

  /// A region that has no net, or none that folds.
  void unsolved(JobState& state, TaskQueue& queue, Search search, Events& events) {
    const Region& region = search.region;
    if (region.cause == Cause::kPart && !is_component(state, region) &&
        state.options.solver == Solver::kTree) {
      // Exchanges wait until all parts have been tried, and then go in the order of parts: each
      // changes the borders that the next one sees.
      const int part = region.part;
      waiting_parts_.insert(part);
      Candidate& best = search.best;
      part_trees_[part] = {{std::move(search.region), std::move(best.folds), best.motion},
                           best.shortfall,
                           best.is_net()};
    } else {
      give_in(state, queue, std::move(search), events);
    }
  }

  /// Takes a net without a motion, where none is required, or splits the region.
  void give_in(JobState& state, TaskQueue& queue, Search search, Events& events) {
    const bool is_net = search.best.is_net();
    if (is_net && state.options.folding != FoldingMode::kRequire) {
      settle(state, std::move(search), events);
    } else {
      split(state, queue, std::move(search.region), is_net ? Cause::kNoMotion : Cause::kNoNet);
    }
  }

  /// The region keeps its best tree as its net.
  void settle(JobState& state, Search search, Events& events) {
    Region& region = search.region;
    if (region.meets_itself) search.best.motion.kind = Folding::kNone;
    panels_done_ += static_cast<int>(region.panels.size());
    events.push_back(NetEvent{region.part, nets_found_++});
    const int part = region.part;
    const bool is_part = region.cause == Cause::kPart;
    FoundNet net{std::move(region), std::move(search.best.folds), std::move(search.best.motion)};
    if (is_part) {
      part_trees_[part] = {std::move(net), 0, true};
    } else {
      state.nets.push_back(std::move(net));
    }
  }

  int component_of(int part) const {
    const auto above = std::upper_bound(first_part_.begin(), first_part_.end(), part);
    return static_cast<int>(above - first_part_.begin()) - 1;
  }

  void next_exchange(const JobState& state, TaskQueue& queue) {
    if (waiting_parts_.empty()) return;
    const int part = *waiting_parts_.begin();
    waiting_parts_.erase(waiting_parts_.begin());
    const int component = component_of(part);
    ExchangeTask task{parts_so_far(state, component), {}};
    task.options.part = part - first_part_[component];
    if (state.options.folding != FoldingMode::kOff) {
      task.options.clearance = state.options.clearance;
    }
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
      if (tree.shortfall > 0) parts.shortfalls[part - first_part_[component]] = tree.shortfall;
    }
    return parts;
  }

  void exchanged(JobState& state, TaskQueue& queue, const ExchangeResult& result, Events& events) {
    const auto [component, part] = *exchanging_;
    exchanging_.reset();
    state.moves += result.moves;
    if (result.found) {
      take_exchange(state, result, component);
      panels_done_ += static_cast<int>(part_trees_[part].net.region.panels.size());
      events.push_back(NetEvent{part, nets_found_++});
    } else {
      uncured_.push_back(part);
    }
    if (waiting_parts_.empty()) give_in_to_rest(state, queue, events);
  }

  void take_exchange(JobState& state, const ExchangeResult& result, int component) {
    labels_changed_ = true;
    state.components[component].labels = result.labels;
    for (const auto& [changed, folds] : result.changed) {
      const int part = first_part_[component] + changed;
      PartTree& tree = part_trees_[part];
      tree = {{whole_part(state, component, part), folds, {}}, 0, true};
      const auto left = result.shortfalls.find(changed);
      if (left == result.shortfalls.end()) {
        if (state.options.folding != FoldingMode::kOff) tree.net.motion = straight_motion(folds);
        // A neighbour may have come to what it lacked on the way.
        waiting_parts_.erase(part);
      } else {
        tree.shortfall = left->second;
        tree.is_net = is_net(state, tree.net);
      }
    }
  }

  static bool is_net(const JobState& state, const FoundNet& net) {
    const DualGraph graph =
        restrict_to(state.components[net.region.component].graph, net.region.panels);
    return overlapping_panels(graph, lay_out(graph, hang_tree(graph, net.folds))).empty();
  }

  /// After the last exchange borders stand still, and what it did not cure gives in.
  void give_in_to_rest(JobState& state, TaskQueue& queue, Events& events) {
    for (const int part : std::exchange(uncured_, {})) {
      // A later exchange with this part as the neighbour may have cured it.
      if (part_trees_.at(part).shortfall == 0) continue;
      PartTree tree = std::move(part_trees_.at(part));
      part_trees_.erase(part);
      Search search{whole_part(state, component_of(part), part), 0, 0, {}};
      search.best = {std::move(tree.net.folds), tree.is_net ? 0 : tree.shortfall, 0, {}};
      search.best.motion.kind = Folding::kNone;
      give_in(state, queue, std::move(search), events);
    }
  }

  /// Splits a region, once its component has been learned.
  void split(JobState& state, TaskQueue& queue, Region region, Cause cause) {
    region.cause = cause;
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
      Region share{component, region.part, cause, {}};
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
    for (Region& region : waiting) {
      const Cause cause = region.cause;
      split(state, queue, std::move(region), cause);
    }
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

  static void note_outcome(JobState& state) {
    struct Outcome {
      int pieces = 0;
      int without_motion = 0;
      bool meets_itself = false;
      Cause cause = Cause::kPart;
    };
    std::map<int, Outcome> outcomes;
    for (const FoundNet& net : state.nets) {
      Outcome& outcome = outcomes[net.region.part];
      ++outcome.pieces;
      outcome.without_motion += net.motion.kind == Folding::kNone;
      outcome.meets_itself |= net.region.meets_itself;
      outcome.cause = net.region.cause;
    }
    for (const auto& [part, outcome] : outcomes) {
      const std::string name = "part " + std::to_string(part + 1);
      if (outcome.pieces > 1) {
        const std::string lack =
            outcome.cause == Cause::kNoMotion ? " does not fold up" : " has no net";
        state.notices.push_back({"part-split", name + lack + " in one piece and became " +
                                                   std::to_string(outcome.pieces) + " pieces"});
      }
      if (outcome.meets_itself) {
        state.notices.push_back(
            {"meets-itself", name + " has faces that run through each other in "
                                    "the model, so no folding of it is free of collisions"});
      } else if (outcome.without_motion > 0) {
        state.notices.push_back(
            {"no-motion", "no way was found to fold up " + name +
                              " in one go without faces running into each other"});
      }
    }
  }

  /// Component and part of the border exchange under way.
  struct Exchanging {
    int component, part;
  };
  /// The best tree of a whole part, and how far it is from what was asked: 0 when it is settled.
  struct PartTree {
    FoundNet net;
    int shortfall = 0;
    bool is_net = false;
  };

  std::vector<int> first_part_;
  SearchHistory history_;
  std::map<int, Search> searches_;      ///< by task
  std::map<int, PartTree> part_trees_;  ///< by part: an exchange may replace them
  std::set<int> waiting_parts_;         ///< whose exchange is to come
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
