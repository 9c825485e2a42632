#pragma once

#include <vector>

#include "unfold/spanning_tree.h"

namespace foldwright {

/// How a net folds up.
enum class Folding {
  kUnchecked,  ///< nobody looked
  kNone,       ///< no motion without collisions was found
  kLine,       ///< all folds turn together, evenly
  kWaypoints,  ///< over shapes in which some folds are ahead of others
};

/// A path of all fold angles from flat (time 0) to the model (time 1), linear between its keys.
///
/// If `kind` is line or waypoints, it is certified: see `Certificate`.
struct FoldMotion {
  Folding kind = Folding::kUnchecked;
  std::vector<double> times;                ///< ascending from 0 to 1; empty without a motion
  std::vector<std::vector<double>> shares;  ///< per key and fold of the tree: of its angle, [0, 1]

  bool certified() const { return kind == Folding::kLine || kind == Folding::kWaypoints; }
};

/// All folds together, certified elsewhere.
FoldMotion straight_motion(const FoldTree& folds);

/// The motion over the given keys, at even times. `shares`: the first all 0, the last all 1.
FoldMotion motion_over(std::vector<std::vector<double>> shares);

/// Per fold of the tree, its share at `time` in [0, 1]. \pre the motion has keys
std::vector<double> shares_at(const FoldMotion& motion, double time);

}  // namespace foldwright
