#pragma once

#include <memory>

#include "fold/motion.h"
#include "fold/shape_trees.h"
#include "fold/waypoint_search.h"

namespace foldwright {

/// Finds a certified motion of a given net [paper, 4.4]: the straight one, else over one or two
/// waypoints, else over any shapes.
class MotionPlanner {
 public:
  /// `foldable` must outlive this object. \pre `folds` spans its graph, and is a net
  MotionPlanner(const Foldable& foldable, FoldTree folds, std::uint64_t seed);
  MotionPlanner(const MotionPlanner&) = delete;
  MotionPlanner& operator=(const MotionPlanner&) = delete;

  /// Does about `work` microseconds' worth; true when it is done.
  bool step(std::int64_t work);

  /// The motion, or one of kind none if none was found. \pre done
  const FoldMotion& motion() const { return motion_; }
  /// Share of its ways tried, in [0, 1].
  double progress() const { return static_cast<double>(stage_) / 4; }

 private:
  void begin_stage();

  const Foldable* foldable_;
  FoldTree folds_;
  std::uint64_t seed_;
  int stage_ = 0;  ///< straight, one waypoint, two, any shapes
  std::unique_ptr<Certificate> straight_;
  std::unique_ptr<WaypointSearch> waypoints_;
  std::unique_ptr<ShapeTrees> shapes_;
  FoldMotion motion_;
};

}  // namespace foldwright
