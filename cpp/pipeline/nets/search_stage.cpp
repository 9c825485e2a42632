#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <set>
#include <utility>

#include "pipeline/nets/coarser_parts.h"
#include "pipeline/nets/net_split.h"
#include "pipeline/nets/part_trees.h"
#include "pipeline/nets/search_history.h"
#include "pipeline/nets/search_limits.h"
#include "pipeline/nets/search_notices.h"
#include "pipeline/nets/spare_nets.h"
#include "pipeline/parts/equal_bodies.h"
#include "pipeline/parts/learning.h"
#include "search/overlap_cut.h"
#include "segment/lock_labels.h"

namespace foldwright {
namespace {

// Temperatures of the attempts in turn: 2 solves nearly all, rare tight regions want less.
constexpr std::array<double, 4> kTemperatures = {2, 1, 3, 0.5};

// A large region goes on from its best tree, which only a hotter search leaves again.
constexpr std::array<double, 4> kTemperaturesOfLarge = {2, 3, 2.5, 1};

// What a search under way counts for in the progress, against one that found its net.
constexpr double kSearchShare = 0.7;

/// A region in search of a net, and the attempt that runs.
struct Search {
  Region region;
  std::uint64_t key = 0;  ///< names the region in its seeds
  int attempt = 0;
  Candidate best;
  FoldTree initial;      ///< tree that the first attempt starts from; empty: from heuristics
  bool at_last = false;  ///< its borders stand still, and what these attempts do not solve is cut
  std::optional<HeldPlace> place = {};  ///< of a net that is kept
};

/// The region itself names its searches in their seeds, since regions come up in any order.
std::uint64_t key_of(const Region& region) {
  std::uint64_t key = static_cast<std::uint64_t>(region.part);
  for (const int panel : region.panels) {
    key = task_seed(key, SeedTag::kSearch, static_cast<std::uint64_t>(panel), 0);
  }
  return key;
}

/// Finds a net for every part, and a motion that folds it up. What has none first exchanges border
/// panels with its neighbours, or is regrouped with them (`PartTrees`); if that does not help it is
/// cut between its overlaps. What evolution does not solve, and what folds in no way where it must,
/// is split with what was learned, recursively [paper, 4.3, 4.4].
///
/// Longer than other files: the ways from one attempt to the next are one state machine, which is
/// easier to follow in one place.
class SearchStage : public Stage {
 public:
  StageId id() const override { return StageId::kSearch; }

  void begin(JobState& state, TaskQueue& queue, Events& events) override {
    trees_.emplace(state);
    std::vector<Region> regions;
    for (int part = 0; part < trees_->part_count(); ++part) {
      Region region = trees_->region(state, part);
      Component& component = state.parts.components[region.component];
      if (component.equal_to) continue;
      panels_to_search_ += static_cast<int>(region.panels.size());
      if (component.kept.empty()) {
        regions.push_back(std::move(region));
        continue;
      }
      keep(state, queue, component, events);
      for (std::vector<int>& panels : std::exchange(component.open, {})) {
        regions.push_back({region.component, region.part, Cause::kEdit, std::move(panels)});
      }
    }
    // The largest first: one that came last would keep a single worker busy.
    std::stable_sort(regions.begin(), regions.end(), [](const Region& a, const Region& b) {
      return a.panels.size() > b.panels.size();
    });
    for (Region& region : regions) start(state, queue, std::move(region));
  }

  void complete(JobState& state, TaskQueue& queue, CompletedTask done, Events& events) override {
    auto& [task, result] = done;
    if (auto* counts = std::get_if<FoldabilityCounts>(&result)) {
      learned(state, queue, task, *counts);
    } else if (auto* exchanged = std::get_if<ExchangeResult>(&result)) {
      this->exchanged(state, queue, *exchanged);
    } else if (auto* planned = std::get_if<PlanResult>(&result)) {
      this->planned(state, queue, task, *planned, events);
    } else {
      searched(state, queue, task, std::get<SearchResult>(result), events);
    }
    if (!searches_.empty() || trees_->exchanging() || regroup(state, queue)) return;
    if (!trees_->begin_exchange(state, queue)) accept_or_split_rest(state, queue, events);
    if (searches_.empty() && waiting_.empty() && !trees_->exchanging()) {
      finish(state, queue, events);
    }
  }

  void end(JobState& state, Events& events) override {
    salvage(state);
    if (state.options.parts.count == 0 && !state.start) {
      // Nobody asked for a number: what did not hold together was no part.
      const int parts = state.parts.count;
      make_parts_of_pieces(state);
      label_faces(state);
      labels_changed_ |= state.parts.count != parts;
    }
    if (labels_changed_) events.push_back(SegmentedEvent{state.parts.labels});
    add_search_notices(state);
  }

  void salvage(JobState& state) override {
    if (!trees_) return;  // it was announced, but has not begun
    trees_->collect(state);
    coarser_.abandon(state);
    add_spare_nets(state, spare_nets());
    if (!std::exchange(carried_equal_, true)) add_nets_of_equal(state);
    label_faces(state);
    sort_nets(state);  // however the searches ended
  }

  void watch(int task, const Running& running, Events& events) override {
    if (const auto search = searches_.find(task); search != searches_.end()) {
      history_.tell(search->second.region.part, running.at(task), events);
    } else if (trees_->exchanging()) {
      history_.tell(trees_->exchanging_part(), running.at(task), events);
    }
  }

  double progress(const JobState&, const Running& running) const override {
    double done = panels_done_;
    for (const auto& [task, status] : running) {
      const auto search = searches_.find(task);
      if (search == searches_.end()) continue;
      // A search that gives up starts over, so that its whole way counts for a part only.
      done +=
          kSearchShare * status.progress * static_cast<double>(search->second.region.panels.size());
    }
    return std::min(1.0, done / std::max(1, panels_to_search_));
  }

 private:
  /// Every region has its net. Bodies whose parts came to many pieces are searched as a whole once;
  /// then bodies that are equal to others get the nets of these.
  void finish(JobState& state, TaskQueue& queue, Events& events) {
    if (coarser_.trying()) {
      labels_changed_ |= coarser_.end(state);
    } else if (!std::exchange(tried_coarser_, true) && !state.start) {
      trees_->collect(state);
      for (Region& whole : coarser_.begin(state)) start(state, queue, std::move(whole));
    }
    if (!searches_.empty() || std::exchange(carried_equal_, true)) return;
    trees_->collect(state);
    labels_changed_ |= follow_equal_bodies(state);
    for (int c = 0; c < static_cast<int>(state.parts.components.size()); ++c) {
      if (!state.parts.components[c].equal_to) continue;
      std::vector<FoundNet> nets = nets_of_equal(state, c);
      if (nets.empty()) search_after_all(state, queue, c);
      for (FoundNet& net : nets) carry(state, queue, std::move(net), events);
    }
  }

  /// Nets that searches under way have come to, and then those that parts had before they got other
  /// borders: a job that ends early hands over what its events have told of.
  std::vector<FoundNet> spare_nets() {
    std::vector<FoundNet> nets;
    for (auto& [task, search] : std::exchange(searches_, {})) {
      Candidate& best = search.best;
      if (!best.is_net()) continue;
      nets.push_back(
          {std::move(search.region), std::move(best.folds), std::move(best.motion), search.place});
    }
    std::ranges::move(trees_->take_earlier(), std::back_inserter(nets));
    return nets;
  }

  /// A net of an equal body becomes one of its own. Where it is not equal to the last digit, it is
  /// looked at again whether it folds.
  void carry(JobState& state, TaskQueue& queue, FoundNet net, Events& events) {
    Search search{std::move(net.region), 0, 0, {}, {}};
    search.best = {std::move(net.folds), 0, 0, std::move(net.motion)};
    if (search.best.motion.kind == Folding::kUnchecked && wants_motion(state, search.region) &&
        !is_too_large_to_plan(state, search.region)) {
      search.key = key_of(search.region);
      plan(state, queue, std::move(search));
    } else {
      accept(state, std::move(search), events);
    }
  }

  /// The parts of a body in which the nets of its equal overlap by a hair.
  void search_after_all(const JobState& state, TaskQueue& queue, int c) {
    const Component& component = state.parts.components[c];
    for (int label = 0; label < static_cast<int>(component.part_numbers.size()); ++label) {
      const int part = component.part_numbers[label];
      // A part that only its equal came to is none that could exchange panels.
      const Cause cause = part < trees_->part_count() ? Cause::kPart : Cause::kNoNet;
      start(state, queue, {c, part, cause, panels_of(component.labels, label)});
    }
  }

  /// Takes the nets of a part that an edit leaves as it is. Those that the edit itself made look
  /// for a motion first.
  void keep(JobState& state, TaskQueue& queue, Component& component, Events& events) {
    for (FoundNet& net : std::exchange(component.kept, {})) {
      // It is told again why it does not fold.
      if (!net.motion.certified()) note_limits(state, net.region);
      const bool is_new = net.motion.kind == Folding::kUnchecked;
      Search search{std::move(net.region), 0, 0, {}, {}};
      search.best = {std::move(net.folds), 0, 0, std::move(net.motion)};
      search.place = net.place;
      if (is_new && wants_motion(state, search.region) &&
          !is_too_large_to_plan(state, search.region)) {
        search.key = key_of(search.region);
        plan(state, queue, std::move(search));
      } else {
        accept(state, std::move(search), events);
      }
    }
  }

  void start(const JobState& state, TaskQueue& queue, Region region, FoldTree initial = {}) {
    note_limits(state, region);
    const std::uint64_t key = key_of(region);
    queue_attempt(state, queue, {std::move(region), key, 0, {}, std::move(initial)});
  }

  void queue_attempt(const JobState& state, TaskQueue& queue, Search search) {
    const std::uint64_t seed = task_seed(state.options.seed, SeedTag::kSearch, search.key,
                                         static_cast<std::uint64_t>(search.attempt));
    if (state.options.nets.solver == Solver::kGenetic) {
      queue_work(state, queue, std::move(search), GeneticTask{{.seed = seed}});
      return;
    }
    const double clearance = wants_motion(state, search.region) ? state.options.nets.clearance : 0;
    // A large region has come too far to begin again.
    const bool is_large = search.region.panels.size() > kLargeRegion;
    const auto& temperatures = is_large ? kTemperaturesOfLarge : kTemperatures;
    const double temperature = temperatures[search.attempt % temperatures.size()];
    SearchTask task{{.temperature = temperature,
                     .patience = patience_for(search.region),
                     .clearance = clearance,
                     .seed = seed},
                    std::exchange(search.initial, {})};
    if (is_large && search.attempt > 0) task.initial = search.best.folds;
    queue_work(state, queue, std::move(search), std::move(task));
  }

  void queue_work(const JobState& state, TaskQueue& queue, Search search, Work work) {
    std::vector<int> panels = model_panels(state, search.region);
    const int id = queue.add(state.model.surface, std::move(panels), std::move(work));
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
    state.nets.moves += result.moves;
    state.nets.generations += result.generations;
    Candidate& best = search.best;
    if (best.overlaps == -1 ||
        std::pair(result.overlaps, result.shortfall) < std::pair(best.overlaps, best.shortfall)) {
      best = {result.folds, result.overlaps, result.shortfall, {}};
      if (result.folds_straight) best.motion = straight_motion(best.folds);
    }
    const bool is_enough =
        best.motion.certified() || state.options.nets.folding == FoldingMode::kOff;
    if (best.is_net() && is_enough) {
      accept(state, std::move(search), events);
    } else if (best.is_net() && !wants_motion(state, search.region)) {
      accept_or_split(state, queue, std::move(search), events);
    } else if (best.is_net() && state.options.nets.solver == Solver::kGenetic) {
      plan(state, queue, std::move(search));
    } else if (++search.attempt < attempts_of(state, search) &&
               !is_hopeless(state, search.region, best)) {
      queue_attempt(state, queue, std::move(search));
    } else if (best.is_net() && is_too_large_to_plan(state, search.region)) {
      accept_or_split(state, queue, std::move(search), events);
    } else if (best.is_net() && !is_for_regrouping(state, search)) {
      plan(state, queue, std::move(search));
    } else {
      unsolved(state, queue, std::move(search), events);
    }
  }

  static int attempts_of(const JobState& state, const Search& search) {
    return search.at_last ? attempts_at_last(state, search.region)
                          : attempts_for(state, search.region, search.best.is_net());
  }

  /// Looks for a motion of a net that does not fold straight.
  void plan(const JobState& state, TaskQueue& queue, Search search) {
    const std::uint64_t seed = task_seed(state.options.seed, SeedTag::kPlanning, search.key, 0);
    PlanTask task{search.best.folds, state.options.nets.clearance, seed};
    queue_work(state, queue, std::move(search), std::move(task));
  }

  void planned(JobState& state, TaskQueue& queue, int task, const PlanResult& result,
               Events& events) {
    Search search = take_search(task);
    search.best.motion = result.motion;
    if (result.motion.certified() || search.region.kept) {
      accept(state, std::move(search), events);
    } else {
      unsolved(state, queue, std::move(search), events);
    }
  }

  /// A region that has no net, or none that folds.
  void unsolved(JobState& state, TaskQueue& queue, Search search, Events& events) {
    if (is_exchangeable(state, search.region) && !search.at_last) {
      trees_->postpone(std::move(search.region), std::move(search.best));
    } else {
      accept_or_split(state, queue, std::move(search), events);
    }
  }

  /// Planning takes longest where a part is far from folding: other borders are the better way.
  bool is_for_regrouping(const JobState& state, const Search& search) const {
    const Region& region = search.region;
    return !search.at_last && is_exchangeable(state, region) && is_far_from_motion(search.best) &&
           trees_->may_regroup(region.part);
  }

  /// Gives parts that need them other borders, and searches them anew; false when there is none.
  bool regroup(JobState& state, TaskQueue& queue) {
    const std::vector<int> again = trees_->regroup_next(state);
    for (const int part : again) start(state, queue, trees_->region(state, part));
    labels_changed_ |= !again.empty();
    return !again.empty();
  }

  void exchanged(JobState& state, TaskQueue& queue, const ExchangeResult& result) {
    state.nets.moves += result.moves;
    for (PartTrees::Changed& changed : trees_->end_exchange(state, result)) {
      labels_changed_ = true;
      start(state, queue, trees_->region(state, changed.part), std::move(changed.folds));
    }
  }

  /// After the last exchange borders stand still, and what it did not cure is tried from more seeds
  /// or accepted as it is.
  void accept_or_split_rest(JobState& state, TaskQueue& queue, Events& events) {
    for (auto& [part, candidate] : trees_->take_uncured()) {
      Search search{trees_->region(state, part), 0, 0, std::move(candidate), {}};
      if (!deserves_last_attempts(state, search.region, search.best)) {
        accept_or_split(state, queue, std::move(search), events);
        continue;
      }
      note_limits(state, search.region);
      search.key = key_of(search.region);
      search.attempt = attempts_for(state, search.region, false);
      search.at_last = true;
      queue_attempt(state, queue, std::move(search));
    }
  }

  /// Takes a net without a motion, where none is required or no fold of it may be cut, or splits
  /// the region.
  void accept_or_split(JobState& state, TaskQueue& queue, Search search, Events& events) {
    const bool is_net = search.best.is_net();
    const DualGraph& whole = state.parts.components[search.region.component].graph;
    const bool must_fold = state.options.nets.folding == FoldingMode::kRequire;
    if (is_net && (!must_fold || is_held_together(restrict_to(whole, search.region.panels)))) {
      accept(state, std::move(search), events);
    } else if (state.options.nets.solver == Solver::kTree && search.best.overlaps > 0) {
      cut_between_overlaps(state, queue, std::move(search));
    } else {
      split(state, queue, std::move(search.region), is_net ? Cause::kNoMotion : Cause::kNoNet);
    }
  }

  /// Cuts the best tree where that parts most overlaps, so that few pieces come of it: what was
  /// learned tells nothing of the one place that is at fault.
  void cut_between_overlaps(const JobState& state, TaskQueue& queue, Search search) {
    const Component& component = state.parts.components[search.region.component];
    const DualGraph graph = restrict_to(component.graph, search.region.panels);
    const int fold = best_overlap_cut(graph, search.best.folds);
    const FoundNet whole{std::move(search.region), std::move(search.best.folds), {}};
    for (FoundNet& half : split_net(component, whole, fold)) {
      half.region.cause = Cause::kNoNet;
      start(state, queue, std::move(half.region), std::move(half.folds));
    }
  }

  /// The region keeps its best tree as its net.
  void accept(JobState& state, Search search, Events& events) {
    Region& region = search.region;
    if (region.meets_itself) search.best.motion.kind = Folding::kNone;
    const int part = region.part;
    const bool is_part = region.cause == Cause::kPart;
    // A part that an exchange changed is told of and counted once.
    if (!is_part || told_parts_.insert(part).second) {
      panels_done_ += static_cast<int>(region.panels.size());
      events.push_back(NetEvent{part, nets_found_++});
    }
    FoundNet net{std::move(region), std::move(search.best.folds), std::move(search.best.motion),
                 search.place};
    if (is_part) {
      trees_->accept(part, std::move(net));
    } else {
      state.nets.found.push_back(std::move(net));
    }
  }

  /// Splits a region, once its component has been learned.
  void split(JobState& state, TaskQueue& queue, Region region, Cause cause) {
    region.cause = cause;
    const int component = region.component;
    if (!state.parts.components[component].learned) {
      const bool asked = std::any_of(learnings_.begin(), learnings_.end(),
                                     [&](const Learning& l) { return l.component() == component; });
      if (!asked) learnings_.emplace_back(state, component, queue);
      waiting_.push_back(std::move(region));
      return;
    }
    const Component& of = state.parts.components[component];
    std::vector<int> rows;
    for (const int panel : region.panels) rows.push_back(of.learned->rows[panel]);
    const DualGraph graph = restrict_to(of.graph, region.panels);
    const Labels halves = halve_between_locks(
        graph, split_in_two(state.model.surface->mesh, graph, {of.learned->matrix, rows}));
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
    state.parts.components[component].learned = learning->finish();
    std::vector<Region> waiting = std::move(waiting_);
    waiting_.clear();
    for (Region& region : waiting) {
      const Cause cause = region.cause;
      split(state, queue, std::move(region), cause);
    }
  }

  std::optional<PartTrees> trees_;
  CoarserParts coarser_;
  bool tried_coarser_ = false;
  bool carried_equal_ = false;
  SearchHistory history_;
  std::map<int, Search> searches_;   ///< by task
  std::vector<Learning> learnings_;  ///< asked for only because a region must be split
  std::vector<Region> waiting_;      ///< regions to split once their component is learned
  std::set<int> told_parts_;
  int panels_to_search_ = 0, panels_done_ = 0;
  int nets_found_ = 0;
  bool labels_changed_ = false;
};

}  // namespace

std::unique_ptr<Stage> make_search_stage() { return std::make_unique<SearchStage>(); }

}  // namespace foldwright
