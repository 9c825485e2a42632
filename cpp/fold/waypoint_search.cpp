#include "fold/waypoint_search.h"

#include <algorithm>
#include <cmath>

namespace foldwright {
namespace {

// Ways along a leg that are looked at first. The end of the last leg is the model itself.
constexpr std::array<double, 5> kFirstSamples = {1, 0.9, 0.7, 0.5, 0.25};

// Ways to share out the folds that are tried to start from; see `propose_start`.
constexpr int kStarts = 8;

// Changes without fewer collisions before the search gives up.
constexpr int kPatience = 400;
// More samples than this tell that the motion is tight everywhere: no binary waypoint will do.
constexpr std::size_t kMostSamples = 60;

// Panels looked at before the search gives up: some seconds.
constexpr std::int64_t kMostLooks = 5'000'000;

// A change may add up to -kTemperature ln(u) collisions.
constexpr double kTemperature = 0.7;

// Folding up and looking for collisions costs about this many microseconds a panel.
constexpr int kLookCost = 1;

}  // namespace

WaypointSearch::WaypointSearch(const Foldable& foldable, const FoldTree& folds, int legs,
                               std::uint64_t seed)
    : foldable_(&foldable),
      folds_(&folds),
      leg_count_(legs),
      random_(seed),
      tree_(hang_tree(*foldable.graph, folds, tree_centre(*foldable.graph, folds))),
      depth_(foldable.graph->panel_count(), 0),
      fold_of_(foldable.graph->panel_count(), -1) {
  for (std::size_t i = 1; i < tree_.order.size(); ++i) {
    const int panel = tree_.order[i];
    depth_[panel] = depth_[tree_.parent[panel]] + 1;
    fold_of_[panel] = static_cast<int>(
        std::lower_bound(folds.begin(), folds.end(), tree_.hinge[panel]) - folds.begin());
  }
  for (int leg = 0; leg < legs; ++leg) {
    for (const double s : kFirstSamples) {
      if (leg < legs - 1 || s < 1) samples_.push_back({leg, s});
    }
  }
}

WaypointSearch::State WaypointSearch::step(std::int64_t work) {
  const std::int64_t look =
      1 + kLookCost * static_cast<std::int64_t>(samples_.size()) * foldable_->graph->panel_count();
  while (state_ == State::kRunning && work > 0) {
    if (certificate_) {
      const std::int64_t slice = std::min(work, kStepSlice);
      if (certificate_->step(slice) != Certificate::State::kRunning) certify();
      work -= slice;
      continue;
    }
    starts_ < kStarts ? propose_start() : move();
    work -= look;
    looks_ += look;
    if (looks_ > kMostLooks && !certificate_) state_ = State::kGaveUp;
  }
  return state_;
}

std::vector<double> WaypointSearch::shares_at(const Sample& sample) const {
  std::vector<double> shares;
  for (const int leg : legs_) {
    shares.push_back(leg < sample.leg ? 1 : leg == sample.leg ? sample.s : 0);
  }
  return shares;
}

std::vector<std::array<int, 2>> WaypointSearch::collisions_at(const Sample& sample) const {
  const auto angles = fold_angles(*foldable_->graph, *folds_, shares_at(sample));
  return colliding_panels(*foldable_, tree_, fold_up(*foldable_, tree_, angles));
}

/// Collisions over all samples, more than `limit` if they are more; remembers a random pair.
int WaypointSearch::count_collisions(double limit) {
  int count = 0;
  for (const Sample& sample : samples_) {
    for (const auto& pair : collisions_at(sample)) {
      // Each pair met so far is kept with equal chance.
      if (random_.below(++count) == 0) worst_pair_ = pair;
    }
    if (count > limit) break;
  }
  return count;
}

/// Tries one way to share out the folds: by depth from either end, by mountains and valleys, by
/// branches of the tree.
void WaypointSearch::propose_start() {
  const DualGraph& graph = *foldable_->graph;
  const int deepest = *std::max_element(depth_.begin(), depth_.end());
  std::vector<int> legs(folds_->size(), 0);
  const int kind = starts_++;
  std::vector<int> leg_of_branch(graph.panel_count(), 0);
  for (const int panel : tree_.order) {
    if (fold_of_[panel] == -1) continue;
    const int by_depth = leg_count_ * (depth_[panel] - 1) / std::max(1, deepest);
    int leg = 0;
    if (kind == 0) leg = leg_count_ - 1 - by_depth;
    if (kind == 1) leg = by_depth;
    const bool is_valley = graph.hinges[tree_.hinge[panel]].angle > 0;
    if (kind == 2) leg = is_valley ? 0 : leg_count_ - 1;
    if (kind == 3) leg = is_valley ? leg_count_ - 1 : 0;
    if (kind >= 4) {
      // A branch keeps its parent's leg, mostly.
      const bool turns = random_.uniform() < 0.2;
      leg = turns ? random_.below(leg_count_) : leg_of_branch[tree_.parent[panel]];
      leg_of_branch[panel] = leg;
    }
    legs[fold_of_[panel]] = leg;
  }
  legs_ = std::move(legs);
  const int count = count_collisions(least_ == -1 ? 1e9 : least_);
  if (least_ == -1 || count < least_) {
    least_ = count;
    best_start_ = legs_;
  }
  if (starts_ < kStarts && least_ > 0) return;
  starts_ = kStarts;
  legs_ = best_start_;
  collisions_ = count_collisions(1e9);
}

/// Moves one fold to another leg, or starts the certificate when nothing collides.
void WaypointSearch::move() {
  if (collisions_ == 0) {
    certified_legs_ = 0;
    const auto all_keys = keys();
    certificate_.emplace(*foldable_, *folds_,
                         Leg{fold_angles(*foldable_->graph, *folds_, all_keys[0]),
                             fold_angles(*foldable_->graph, *folds_, all_keys[1])});
    return;
  }
  if (++since_least_ > kPatience) {
    state_ = State::kGaveUp;
    return;
  }
  const std::vector<int> before = legs_;
  const std::array<int, 2> pair_before = worst_pair_;
  choose_fold();
  const double limit = collisions_ - kTemperature * std::log(1 - random_.uniform());
  const int count = count_collisions(limit);
  if (count > limit) {
    legs_ = before;
    worst_pair_ = pair_before;
    return;
  }
  collisions_ = count;
  if (count < least_) {
    least_ = count;
    since_least_ = 0;
  }
}

/// Gives a random fold between the colliding panels another leg, now and then with its branch.
void WaypointSearch::choose_fold() {
  std::vector<int> panels;
  auto [a, b] = worst_pair_;
  while (a != b) {
    int& lower = depth_[a] >= depth_[b] ? a : b;
    panels.push_back(lower);
    lower = tree_.parent[lower];
  }
  const int top = panels[random_.below(static_cast<int>(panels.size()))];
  const int leg = (legs_[fold_of_[top]] + 1 + random_.below(leg_count_ - 1)) % leg_count_;
  legs_[fold_of_[top]] = leg;
  if (random_.below(3) != 0) return;
  std::vector<char> below(foldable_->graph->panel_count(), 0);
  below[top] = 1;
  for (const int panel : tree_.order) {
    if (tree_.parent[panel] == -1 || !below[tree_.parent[panel]]) continue;
    below[panel] = 1;
    legs_[fold_of_[panel]] = leg;
  }
}

/// Takes the verdict on a leg: goes on to the next one, or looks at more samples.
void WaypointSearch::certify() {
  const int leg = certified_legs_;
  if (certificate_->state() == Certificate::State::kRefuted) {
    for (const double s : certificate_->counterexamples()) samples_.push_back({leg, s});
    certificate_.reset();
    if (samples_.size() > kMostSamples) state_ = State::kGaveUp;
    collisions_ = least_ = count_collisions(1e9);
    // The certificate may fail where nothing meets yet; then there is nothing to improve on.
    if (collisions_ == 0) state_ = State::kGaveUp;
    return;
  }
  if (++certified_legs_ == leg_count_) {
    certificate_.reset();
    state_ = State::kFound;
    return;
  }
  const auto all_keys = keys();
  certificate_.emplace(*foldable_, *folds_,
                       Leg{fold_angles(*foldable_->graph, *folds_, all_keys[certified_legs_]),
                           fold_angles(*foldable_->graph, *folds_, all_keys[certified_legs_ + 1])});
}

std::vector<std::vector<double>> WaypointSearch::keys() const {
  std::vector<std::vector<double>> keys;
  for (int key = 0; key <= leg_count_; ++key) {
    std::vector<double>& shares = keys.emplace_back();
    for (const int leg : legs_) shares.push_back(leg < key ? 1 : 0);
  }
  return keys;
}

}  // namespace foldwright
