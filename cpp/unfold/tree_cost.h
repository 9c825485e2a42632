#pragma once

#include "geometry/random.h"
#include "unfold/layout.h"

namespace foldwright {

/// A swap on a fold tree that is laid flat: a fold is cut, and the panels on one side of it move
/// rigidly to hang at another hinge.
struct TreeSwap {
  int cut, join;               ///< hinges
  std::span<const int> moved;  ///< panels
  RigidMotion2 motion;         ///< from where they lie to where they would
};

/// What a net costs beyond being one: a search keeps it small without knowing what it is about.
/// Costs are kept up to date under swaps.
class TreeCost {
 public:
  virtual ~TreeCost() = default;

  /// Starts over from a net. `places`: where each panel lies
  virtual void lay(const FoldTree& folds, const Layout& places) = 0;
  /// Of the net as it is.
  virtual double cost() const = 0;
  /// What it would be after a swap; may stop counting above `limit` and then returns more than it.
  /// \pre the swap leads to a net
  virtual double try_swap(const TreeSwap& swap, double limit) = 0;
  /// Makes the swap that was tried last. \pre its cost was counted to the end
  virtual void accept() = 0;
  /// A hinge that is cut and had better be a fold, at random; -1 if there is none.
  virtual int worst_cut(Random& random) const = 0;
  /// Work of the last trial in about microseconds.
  virtual std::int64_t work() const = 0;
};

}  // namespace foldwright
