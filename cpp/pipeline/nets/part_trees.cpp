#include "pipeline/nets/part_trees.h"

#include <algorithm>
#include <utility>

#include "pipeline/nets/search_limits.h"
#include "segment/lock_labels.h"
#include "segment/regroup.h"

namespace foldwright {
namespace {

// Exchanges of one part: the first gives it a net, another one, if need be, a net that folds.
constexpr int kMostExchanges = 3;

// A part is far from a net with so many overlaps for each of its panels, but not with fewer than
// the least of these, and always with the most. Exchanges cure one overlap in a hundred panels and
// less.
constexpr double kFarShare = 0.02;
constexpr double kLeastFar = 10;
constexpr double kMostFar = 40;

// A part of fewer panels that no exchange cures is not joined to another one but cut: that makes
// one piece more at most, while what is joined may not fold.
constexpr std::size_t kSmall = 50;

// Moves of an exchange times panels for large parts: each move takes the longer the larger the part
// is, and what is cured at all is cured soon.
constexpr std::int64_t kWorkOfLarge = 500'000'000;

int count_overlaps(const DualGraph& graph, const FoldTree& folds) {
  return static_cast<int>(
      overlapping_panels(graph, lay_out(graph, hang_tree(graph, folds))).size());
}

}  // namespace

bool is_far_from_net(const Region& region, const Candidate& candidate) {
  const auto panels = static_cast<double>(region.panels.size());
  return candidate.overlaps >= std::clamp(kFarShare * panels, kLeastFar, kMostFar);
}

bool is_far_from_motion(const Candidate& candidate) {
  return candidate.is_net() && candidate.shortfall >= kMostFar;
}

PartTrees::PartTrees(const JobState& state) {
  std::map<int, Place> places;
  for (int c = 0; c < static_cast<int>(state.parts.components.size()); ++c) {
    int label = 0;
    for (const int part : state.parts.components[c].part_numbers) places[part] = {c, label++};
  }
  for (const auto& [part, place] : places) parts_.push_back(place);
}

Region PartTrees::region(const JobState& state, int part) const {
  Region region;
  region.component = parts_[part].component;
  region.part = part;
  region.panels = panels_of(state.parts.components[region.component].labels, parts_[part].label);
  return region;
}

void PartTrees::accept(int part, FoundNet net) { trees_[part] = {std::move(net), 0, 0}; }

void PartTrees::postpone(Region region, Candidate candidate) {
  const int part = region.part;
  const bool is_far = is_far_from_net(region, candidate) || is_far_from_motion(candidate);
  if (is_far && may_regroup(part)) {
    to_regroup_.insert(part);
  } else {
    (exchanges_[part] < kMostExchanges ? waiting_ : uncured_).insert(part);
  }
  trees_[part] = {{std::move(region), std::move(candidate.folds), std::move(candidate.motion)},
                  candidate.overlaps,
                  candidate.shortfall};
}

std::vector<int> PartTrees::regroup_next(JobState& state) {
  while (!to_regroup_.empty()) {
    const int part = *to_regroup_.begin();
    const auto [c, label] = parts_[part];
    Component& component = state.parts.components[c];
    regrouped_.insert(part);
    to_regroup_.erase(part);
    const int learned_panels =
        component.learned ? component.learned->matrix.size : component.graph.panel_count();
    auto regrouping = regroup(state.model.surface->mesh, component.graph, component.labels,
                              {.part = label, .learned_panels = learned_panels});
    if (regrouping) {
      // What folds that stay hold together cannot be shared out as it was.
      const Labels kept = keep_locked_together(component.graph, regrouping->labels);
      if (kept != regrouping->labels) regrouping.reset();
    }
    if (!regrouping && trees_.at(part).overlaps == 0) {
      // Searched again, it is planned a motion for within its own borders.
      forget(part);
      return {part};
    }
    if (!regrouping) {
      // What is far from a net and large takes an exchange seconds to no avail.
      const bool is_large = trees_.at(part).net.region.panels.size() > kLargeRegion;
      (exchanges_[part] == 0 && !is_large ? waiting_ : uncured_).insert(part);
      continue;
    }
    component.labels = std::move(regrouping->labels);
    std::vector<int> again;
    for (const int changed : regrouping->changed) again.push_back(component.part_numbers[changed]);
    for (const int changed : again) forget(changed);
    return again;
  }
  return {};
}

void PartTrees::forget(int part) {
  to_regroup_.erase(part);
  waiting_.erase(part);
  uncured_.erase(part);
  const auto tree = trees_.find(part);
  if (tree == trees_.end()) return;
  if (tree->second.overlaps == 0) earlier_[part] = std::move(tree->second.net);
  trees_.erase(tree);
}

bool PartTrees::begin_exchange(const JobState& state, TaskQueue& queue) {
  if (waiting_.empty()) return false;
  const int part = *waiting_.begin();
  waiting_.erase(waiting_.begin());
  const auto [component, label] = parts_[part];
  // A part without a net is given any: nearly all nets can be made to fold afterwards, and looking
  // at both in every step takes far longer.
  const bool for_motion = trees_.at(part).overlaps == 0;
  ExchangeTask task{parts_so_far(state, component, for_motion), {}};
  task.options.part = label;
  if (const std::size_t panels = trees_.at(part).net.region.panels.size(); panels > kLargeRegion) {
    task.options.most_moves = kWorkOfLarge / static_cast<std::int64_t>(panels);
  }
  task.options.clearance = for_motion ? state.options.nets.clearance : 0;
  task.options.seed =
      task_seed(state.options.seed, SeedTag::kExchange, static_cast<std::uint64_t>(part),
                static_cast<std::uint64_t>(exchanges_[part]++));
  queue.add(state.model.surface, state.parts.components[component].panels, std::move(task));
  exchange_ = part;
  return true;
}

PartsSoFar PartTrees::parts_so_far(const JobState& state, int component, bool for_motion) const {
  const Component& of = state.parts.components[component];
  PartsSoFar parts{of.labels, {}, {}};
  for (std::size_t label = 0; label < of.part_numbers.size(); ++label) {
    const Tree& tree = trees_.at(of.part_numbers[label]);
    const DualGraph graph = restrict_to(of.graph, tree.net.region.panels);
    for (const int h : tree.net.folds) parts.fold_edges.push_back(graph.hinges[h].edges[0]);
    const int shortfall = for_motion ? tree.shortfall : tree.overlaps;
    if (shortfall > 0) parts.shortfalls[static_cast<int>(label)] = shortfall;
  }
  return parts;
}

std::vector<PartTrees::Changed> PartTrees::end_exchange(JobState& state,
                                                        const ExchangeResult& result) {
  const int part = *std::exchange(exchange_, std::nullopt);
  const int component = parts_[part].component;
  std::vector<Changed> again;
  if (!result.found) {
    const Tree& tree = trees_.at(part);
    const bool helps = tree.overlaps > 0 && tree.net.region.panels.size() > kSmall;
    (helps && may_regroup(part) ? to_regroup_ : uncured_).insert(part);
    return again;
  }
  state.parts.components[component].labels = result.labels;
  for (const auto& [label, folds] : result.changed) {
    const int changed = state.parts.components[component].part_numbers[label];
    const auto left = result.shortfalls.find(label);
    if (left != result.shortfalls.end()) {
      // It is no better off than before, and goes on waiting.
      Region now = region(state, changed);
      const DualGraph graph = restrict_to(state.parts.components[component].graph, now.panels);
      const int overlaps = count_overlaps(graph, folds);
      trees_[changed] = {{std::move(now), folds, {}}, overlaps, left->second};
      continue;
    }
    forget(changed);
    again.push_back({changed, folds});
  }
  return again;
}

std::vector<std::pair<int, Candidate>> PartTrees::take_uncured() {
  std::vector<std::pair<int, Candidate>> uncured;
  for (const int part : std::exchange(uncured_, {})) {
    Tree tree = std::move(trees_.at(part));
    trees_.erase(part);
    uncured.push_back({part, {std::move(tree.net.folds), tree.overlaps, tree.shortfall, {}}});
    uncured.back().second.motion.kind = Folding::kNone;
  }
  return uncured;
}

void PartTrees::collect(JobState& state) {
  for (auto& [part, tree] : trees_) {
    if (tree.overlaps == 0) state.nets.found.push_back(std::move(tree.net));
  }
  trees_.clear();
}

std::vector<FoundNet> PartTrees::take_earlier() {
  std::vector<FoundNet> nets;
  for (auto& [part, net] : std::exchange(earlier_, {})) nets.push_back(std::move(net));
  return nets;
}

}  // namespace foldwright
