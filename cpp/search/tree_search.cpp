#include "search/tree_search.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "unfold/directions.h"

namespace foldwright {
namespace {

// A pair counts once in each layer where it collides, so a step over a ridge costs more: of whole
// models of 2000 faces twice as many are solved from one seed as without this factor.
constexpr double kLayeredTemperature = 1.7;

// Panels that a swap may touch on average before it costs patience: twice what swaps touch where
// panels have one face each.
std::int64_t usual_touch(int panels) { return 200 + panels / 4; }

// Lengths that differ by less than this share of the mean edge count as equal, so that rounding
// does not decide about the nets of regular bodies.
constexpr double kSameLength = 1e-6;

/// The fold tree that leaves least to be glued: its folds are as long as they may be.
FoldTree shortest_cuts(const DualGraph& graph) {
  std::vector<double> weights;
  for (const Hinge& hinge : graph.hinges) {
    weights.push_back(-std::round(hinge.length / (kSameLength * graph.unit)));
  }
  return minimum_spanning_tree(graph, weights);
}

}  // namespace

TreeSearch::TreeSearch(const Mesh& mesh, const DualGraph& graph, const TreeSearchOptions& options,
                       const FoldTree& initial)
    : graph_(&graph), options_(options), weights_(mesh, graph), random_(options.seed) {
  if (options_.clearance > 0) layers_.emplace(graph, options_.clearance);
  if (initial.empty()) return;
  starts_done_ = options_.starts;
  consider(initial);
}

TreeSearch::State TreeSearch::step(std::int64_t work) {
  while (state_ == State::kRunning && work > 0) {
    if (layers_ && layers_->is_certifying()) {
      work -= layers_->certify(work);
      if (layers_->is_decided()) judge_certificate();
    } else if (starts_done_ < options_.starts && best_overlaps_ != 0) {
      try_start();
      work -= graph_->panel_count();
    } else if (!layout_) {
      layout_.emplace(*graph_, best_);
      note_progress();
    } else {
      // A touched panel costs some tenths of a microsecond in each layer.
      const std::int64_t touched = move();
      touched_ += touched;
      work -= 1 + touched * (1 + layout_->layer_count()) / 4;
      if (is_out_of_patience()) state_ = State::kGaveUp;
    }
  }
  return state_;
}

void TreeSearch::try_start() {
  // What people draw by hand, where it is a net: a strip of walls with a lid at either end.
  if (starts_done_ == 0 && is_of_polygons(*graph_)) consider(shortest_cuts(*graph_));
  if (best_overlaps_ == 0) return;
  const Heuristic heuristic =
      starts_done_ % 2 == 0 ? Heuristic::kSteepestEdge : Heuristic::kFlatTree;
  const Vec3 direction = random_direction(random_);
  const auto weights = weights_.weights(heuristic, direction, starts_done_, random_);
  consider(minimum_spanning_tree(*graph_, weights));
  ++starts_done_;
}

void TreeSearch::consider(FoldTree folds) {
  const RootedTree tree = hang_tree(*graph_, folds);
  const auto overlaps =
      static_cast<int>(overlapping_panels(*graph_, lay_out(*graph_, tree)).size());
  if (best_overlaps_ != -1 && overlaps >= best_overlaps_) return;
  best_overlaps_ = overlaps;
  best_ = std::move(folds);
  if (overlaps <= options_.good_enough && (!layers_ || overlaps > 0)) state_ = State::kFound;
}

/// A fold on the path between a random pair in conflict, more likely near its ends: cutting there
/// moves few panels. None if no fold there may be cut.
std::optional<int> TreeSearch::choose_cut() {
  const auto [a, b] = layout_->random_conflict(random_);
  layout_->path(a, b, path_);
  if (path_.empty()) return std::nullopt;
  const int length = static_cast<int>(path_.size());
  int at = 0;
  while (at + 1 < length && random_.uniform() < 0.7) ++at;
  return path_[random_.below(2) == 0 ? at : length - 1 - at];
}

bool TreeSearch::is_out_of_patience() const {
  return moves_ - best_move_ > options_.patience ||
         touched_ / usual_touch(graph_->panel_count()) > options_.patience;
}

std::int64_t TreeSearch::move() {
  ++moves_;
  const std::optional<int> cut = choose_cut();
  if (!cut) return 1;
  layout_->select_side(*cut);
  const auto joins = layout_->joins();
  if (joins.empty()) return 1;
  const int join = joins[random_.below(static_cast<int>(joins.size()))];
  const int old = layout_->crossing_conflicts();
  // 1 - u lies in (0, 1], so the logarithm is finite.
  const bool has_layers = layers_ && !layers_->empty();
  const double temperature = options_.temperature * (has_layers ? kLayeredTemperature : 1);
  const double limit = old - temperature * std::log(1 - random_.uniform());
  const int now = layout_->try_join(join, limit);
  const std::int64_t touched = layout_->trial_cost();
  if (now > limit) return touched;
  layout_->accept();
  if (++accepted_ % kRefreshEvery == 0) layout_->refresh();
  note_progress();
  return 2 * touched;
}

/// Looks whether the tree that was just reached is a new best.
void TreeSearch::note_progress() {
  if (least_conflicts_ != -1 && layout_->conflict_count() >= least_conflicts_) return;
  // A net counts only when the tree laid out anew has no conflict either.
  if (layout_->conflict_count() == 0 && moves_ > 0) layout_->refresh();
  least_conflicts_ = layout_->conflict_count();
  best_move_ = moves_;
  touched_ = 0;
  note_best();
  if (least_conflicts_ == 0) {
    finish_or_fold();
  } else if (least_conflicts_ <= options_.good_enough) {
    state_ = State::kFound;
  }
}

void TreeSearch::note_best() {
  const auto now = std::pair(layout_->overlap_count(), layout_->collision_count());
  if (best_overlaps_ != -1 && now > std::pair(best_overlaps_, best_collisions_)) return;
  std::tie(best_overlaps_, best_collisions_) = now;
  best_ = layout_->folds();
}

/// The tree has no conflict in the layers there are.
void TreeSearch::finish_or_fold() {
  if (!layers_) {
    state_ = State::kFound;
  } else if (layers_->empty()) {
    layers_->add_first(*layout_);
    look_at_layers();
  } else {
    layers_->begin_certificate(best_);
  }
}

void TreeSearch::judge_certificate() {
  const auto counterexamples = layers_->take_counterexamples();
  if (!counterexamples) {
    state_ = State::kFound;
    return;
  }
  const bool added = layers_->add(*counterexamples, *layout_);
  look_at_layers();
  if (!added) state_ = State::kGaveUp;
}

/// Counts anew once there may be more layers.
void TreeSearch::look_at_layers() {
  best_collisions_ = layout_->collision_count();
  least_conflicts_ = -1;
  note_progress();
}

int TreeSearch::shortfall() const {
  // A net whose motion is not certified yet is one short at least.
  return state_ == State::kFound && options_.good_enough == 0
             ? 0
             : std::max(best_overlaps_ + best_collisions_, layers_ ? 1 : 0);
}

std::vector<std::array<int, 2>> TreeSearch::conflicts() const {
  MovingLayout layout(*graph_, best_);
  if (layers_) layers_->lay(layout);
  return layout.conflicts();
}

double TreeSearch::impatience() const {
  return std::min(
      1.0, static_cast<double>(moves_ - best_move_) / static_cast<double>(options_.patience));
}

}  // namespace foldwright
