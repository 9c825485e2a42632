#include "search/tree_search.h"

#include <algorithm>
#include <cmath>

#include "unfold/directions.h"

namespace foldwright {
namespace {

// After so many accepted moves the layout is built anew, before rounding can pile up.
constexpr std::int64_t kRefreshEvery = 2000;

}  // namespace

TreeSearch::TreeSearch(const Mesh& mesh, const DualGraph& graph, const TreeSearchOptions& options,
                       const FoldTree& initial)
    : graph_(&graph), options_(options), weights_(mesh, graph), random_(options.seed) {
  if (initial.empty()) return;
  starts_done_ = options_.starts;
  consider(initial);
}

TreeSearch::State TreeSearch::step(std::int64_t work) {
  while (state_ == State::kRunning && work > 0) {
    if (starts_done_ < options_.starts) {
      try_start();
      work -= graph_->panel_count();
      continue;
    }
    if (!layout_) layout_.emplace(*graph_, best_);
    // A touched panel costs some tenths of a microsecond.
    work -= 1 + move() / 4;
    if (moves_ - best_move_ > options_.patience) state_ = State::kGaveUp;
  }
  return state_;
}

void TreeSearch::try_start() {
  const Heuristic heuristic =
      starts_done_ % 2 == 0 ? Heuristic::kSteepestEdge : Heuristic::kFlatTree;
  const Vec3 direction = random_direction(random_);
  consider(heuristic_tree(weights_, *graph_, heuristic, direction, starts_done_, random_));
  ++starts_done_;
}

void TreeSearch::consider(FoldTree folds) {
  const RootedTree tree = hang_tree(*graph_, folds);
  const auto overlaps =
      static_cast<int>(overlapping_panels(*graph_, lay_out(*graph_, tree)).size());
  if (best_overlaps_ != -1 && overlaps >= best_overlaps_) return;
  best_overlaps_ = overlaps;
  best_ = std::move(folds);
  if (best_overlaps_ <= options_.good_enough) state_ = State::kFound;
}

/// A fold on the path between a random overlapping pair, more likely near its ends: cutting there
/// moves few panels.
int TreeSearch::choose_cut() {
  const auto conflicted = layout_->conflicted();
  const int a = conflicted[random_.below(static_cast<int>(conflicted.size()))];
  const auto partners = layout_->partners(a);
  const int b = partners[random_.below(static_cast<int>(partners.size()))];
  layout_->path(a, b, path_);
  const int length = static_cast<int>(path_.size());
  int at = 0;
  while (at + 1 < length && random_.uniform() < 0.7) ++at;
  return path_[random_.below(2) == 0 ? at : length - 1 - at];
}

int TreeSearch::move() {
  ++moves_;
  layout_->select_side(choose_cut());
  const auto joins = layout_->joins();
  if (joins.empty()) return 1;
  const int join = joins[random_.below(static_cast<int>(joins.size()))];
  const int old = layout_->crossing_overlaps();
  // 1 - u lies in (0, 1], so the logarithm is finite.
  const double limit = old - options_.temperature * std::log(1 - random_.uniform());
  const int now = layout_->try_join(join, limit);
  const int touched = layout_->selected_size();
  if (now > limit) return touched;
  layout_->accept();
  if (++accepted_ % kRefreshEvery == 0) layout_->refresh();
  if (layout_->overlap_count() < best_overlaps_) note_best();
  return 2 * touched;
}

void TreeSearch::note_best() {
  // A net counts only when the tree laid out anew has no overlap either.
  if (layout_->overlap_count() == 0) layout_->refresh();
  if (layout_->overlap_count() >= best_overlaps_) return;
  best_overlaps_ = layout_->overlap_count();
  best_ = layout_->folds();
  best_move_ = moves_;
  if (best_overlaps_ <= options_.good_enough) state_ = State::kFound;
}

double TreeSearch::impatience() const {
  return std::min(
      1.0, static_cast<double>(moves_ - best_move_) / static_cast<double>(options_.patience));
}

}  // namespace foldwright
