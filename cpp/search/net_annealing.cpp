#include "search/net_annealing.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace foldwright {
namespace {

// The whole motion is certified this often, the last time when the work is done.
constexpr int kChecks = 3;

// What a check counts for per panel, in about microseconds.
constexpr std::int64_t kCheckWork = 200;

// Share of the work that searching a collision away may take before the annealing goes back to the
// last net that passed.
constexpr double kMostMending = 0.1;

// Checks and mending come on top of the work asked for, up to this multiple of it.
constexpr std::int64_t kMostWork = 2;

}  // namespace

NetAnnealing::NetAnnealing(const DualGraph& graph, FoldTree net, std::unique_ptr<TreeCost> cost,
                           const AnnealingOptions& options)
    : graph_(&graph),
      options_(options),
      cost_(std::move(cost)),
      random_(options.seed),
      best_(std::move(net)),
      next_check_(options.work / kChecks) {
  if (options_.clearance > 0) layers_.emplace(graph, options_.clearance);
  restart_from_best();
  if (layers_) layers_->add_first(*layout_);
  first_cost_ = best_cost_ = cost_->cost();
  if (graph.hinge_count() + 1 == graph.panel_count() || options_.work <= 0) state_ = State::kDone;
}

void NetAnnealing::restart_from_best() {
  mending_ = 0;
  layout_.emplace(*graph_, best_);
  if (layers_) layers_->lay(*layout_);
  cost_->lay(best_, layout_->flat().places());
}

void NetAnnealing::refresh() {
  layout_->refresh();
  cost_->lay(layout_->folds(), layout_->flat().places());
}

NetAnnealing::State NetAnnealing::step(std::int64_t work) {
  while (state_ == State::kRunning && work > 0) {
    if (layers_ && layers_->is_certifying()) {
      // Not counted as spent: how a check is sliced must not matter.
      work -= layers_->certify(work);
      if (layers_->is_decided()) end_check();
      continue;
    }
    std::int64_t done = 0;
    if (layout_->conflict_count() > 0) {
      done = mend();
      mending_ += done;
      if (static_cast<double>(mending_) > kMostMending * static_cast<double>(options_.work)) {
        restart_from_best();
      }
    } else if (spent_ >= next_check_) {
      begin_check();
      done = kCheckWork * graph_->panel_count();
    } else {
      done = move();
    }
    work -= done;
    spent_ += done;
    if (spent_ > kMostWork * options_.work) state_ = State::kDone;
  }
  return state_;
}

double NetAnnealing::temperature() const {
  return options_.hot * std::pow(options_.cold / options_.hot, progress());
}

double NetAnnealing::progress() const {
  return std::min(1.0, static_cast<double>(spent_) / static_cast<double>(options_.work));
}

/// Chooses a hinge to become a fold and a fold of the loop to be cut, if one of it may be.
bool NetAnnealing::choose_swap() {
  join_ = random_.below(2) == 0 ? cost_->worst_cut(random_) : -1;
  while (join_ == -1) {
    const int hinge = random_.below(graph_->hinge_count());
    if (!layout_->tree().is_fold(hinge)) join_ = hinge;
  }
  const auto [a, b] = graph_->hinges[join_].panels;
  layout_->path(a, b, path_);
  if (path_.empty()) return false;
  layout_->select_side(path_[random_.below(static_cast<int>(path_.size()))]);
  return true;
}

std::int64_t NetAnnealing::move() {
  ++moves_;
  if (!choose_swap()) return 1;
  const bool overlaps = layout_->try_flat(join_, 0) > 0;
  const std::int64_t touched = layout_->trial_cost();
  std::int64_t work = 1 + touched / 4;
  if (overlaps) return work;
  const double limit = cost_->cost() - temperature() * std::log(1 - random_.uniform());
  const TreeSwap swap = {layout_->tree().cut(), join_, layout_->tree().selected(),
                         layout_->flat().trial_motion()};
  const double now = cost_->try_swap(swap, limit);
  work += cost_->work();
  if (now > limit) return work;
  work += touched * layout_->layer_count() / 4;
  if (layout_->try_layers(0) > 0) return work;
  layout_->accept();
  cost_->accept();
  if (++accepted_ % kRefreshEvery == 0) refresh();
  if (!layers_ && now < best_cost_) {
    best_cost_ = now;
    best_ = layout_->folds();
  }
  return 2 * work;
}

/// A move that searches a collision away, whatever it costs.
std::int64_t NetAnnealing::mend() {
  ++moves_;
  const auto [a, b] = layout_->random_conflict(random_);
  layout_->path(a, b, path_);
  if (path_.empty()) return 1;
  layout_->select_side(path_[random_.below(static_cast<int>(path_.size()))]);
  const auto joins = layout_->joins();
  const auto work_for = [&](std::int64_t touched) {
    return 1 + touched * (1 + layout_->layer_count()) / 4;
  };
  if (joins.empty()) return work_for(layout_->selected_size());
  join_ = joins[random_.below(static_cast<int>(joins.size()))];
  const int old = layout_->crossing_conflicts();
  const bool overlaps = layout_->try_flat(join_, 0) > 0;
  const std::int64_t work = work_for(layout_->trial_cost());
  if (overlaps || layout_->try_layers(old) > old) return work;
  const TreeSwap swap = {layout_->tree().cut(), join_, layout_->tree().selected(),
                         layout_->flat().trial_motion()};
  cost_->try_swap(swap, std::numeric_limits<double>::infinity());
  layout_->accept();
  cost_->accept();
  return 2 * work + cost_->work();
}

void NetAnnealing::begin_check() {
  refresh();
  if (layout_->conflict_count() > 0) {
    restart_from_best();  // rounding alone: too rare to be mended
  } else if (!layers_) {
    end_check();
  } else {
    layers_->begin_certificate(layout_->folds());
  }
}

void NetAnnealing::end_check() {
  const auto counterexamples = layers_ ? layers_->take_counterexamples() : std::nullopt;
  if (!counterexamples) {
    if (cost_->cost() < best_cost_) {
      best_cost_ = cost_->cost();
      best_ = layout_->folds();
    }
    next_check_ += options_.work / kChecks;
    mending_ = 0;
    if (spent_ >= options_.work) state_ = State::kDone;
  } else if (!layers_->add(*counterexamples, *layout_)) {
    restart_from_best();
  }
}

}  // namespace foldwright
