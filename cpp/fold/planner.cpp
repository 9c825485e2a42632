#include "fold/planner.h"

namespace foldwright {

MotionPlanner::MotionPlanner(const Foldable& foldable, FoldTree folds, std::uint64_t seed)
    : foldable_(&foldable), folds_(std::move(folds)), seed_(seed) {
  begin_stage();
}

void MotionPlanner::begin_stage() {
  straight_.reset();
  waypoints_.reset();
  shapes_.reset();
  if (stage_ == 0) {
    straight_ = std::make_unique<Certificate>(*foldable_, folds_, straight_leg(*foldable_->graph));
  } else if (stage_ <= 2) {
    waypoints_ = std::make_unique<WaypointSearch>(*foldable_, folds_, stage_ + 1, seed_);
  } else if (stage_ == 3) {
    shapes_ = std::make_unique<ShapeTrees>(*foldable_, folds_, seed_);
  } else {
    motion_.kind = Folding::kNone;
  }
}

bool MotionPlanner::step(std::int64_t work) {
  if (motion_.kind != Folding::kUnchecked) return true;
  bool ended = false;
  if (straight_) {
    ended = straight_->step(work) != Certificate::State::kRunning;
    if (straight_->state() == Certificate::State::kCertified) motion_ = straight_motion(folds_);
  } else if (waypoints_) {
    ended = waypoints_->step(work) != WaypointSearch::State::kRunning;
    if (waypoints_->state() == WaypointSearch::State::kFound) {
      motion_ = motion_over(waypoints_->keys());
    }
  } else {
    ended = shapes_->step(work) != ShapeTrees::State::kRunning;
    if (shapes_->state() == ShapeTrees::State::kFound) motion_ = motion_over(shapes_->keys());
  }
  if (ended && motion_.kind == Folding::kUnchecked) {
    ++stage_;
    begin_stage();
  }
  return motion_.kind != Folding::kUnchecked;
}

}  // namespace foldwright
