#pragma once

#include <optional>

#include "geometry/random.h"
#include "search/moving_places.h"

namespace foldwright {

/// A fold tree under swaps, flat and at some shares of its folding: overlaps in the plane and
/// collisions in space are kept up to date.
class MovingLayout {
 public:
  /// Both must outlive this object. \pre `folds` spans the graph
  MovingLayout(const DualGraph& graph, std::span<const int> folds);

  FoldTree folds() const { return tree_.folds(); }
  const MovingTree& tree() const { return tree_; }

  /// Looks at collisions with every fold at this share of its angle, too.
  void add_layer(const Foldable& foldable, double share);
  int layer_count() const { return static_cast<int>(folded_.size()); }

  /// Overlapping pairs of panels in the plane.
  int overlap_count() const { return flat_.collision_count(); }
  /// Colliding pairs in space, over all layers.
  int collision_count() const;
  int conflict_count() const { return overlap_count() + collision_count(); }

  const MovingPlaces<FlatSpace>& flat() const { return flat_; }
  /// Two panels that collide in some layer. \pre `conflict_count()` > 0
  std::array<int, 2> random_conflict(Random& random) const;
  /// All of them, layer by layer.
  std::vector<std::array<int, 2>> conflicts() const;

  /// Folds on the way from panel `a` to panel `b`, in that order.
  void path(int a, int b, std::vector<int>& folds) { tree_.path(a, b, folds); }
  /// Splits the tree at fold `cut` and selects the smaller side as the one to move.
  void select_side(int cut) { tree_.select_side(cut); }
  /// Hinges that could replace the cut: all others between the two sides.
  std::span<const int> joins() const { return tree_.joins(); }
  int selected_size() const { return static_cast<int>(tree_.selected().size()); }
  /// Cost of the swap that was tried last, in panels of one face: those selected, and more where
  /// panels have many faces. The cost in each layer is about the same.
  std::int64_t trial_cost() const { return selected_size() + flat_.trial_excess(); }
  /// Conflicts between the two sides as they lie now.
  int crossing_conflicts() const;

  /// Conflicts between the sides if the selected one were hung at `join`; stops counting above
  /// `limit` and then returns more than it.
  int try_join(int join, double limit);
  /// Its two halves, for those who look at other things in between: overlaps in the plane, and then
  /// collisions in the layers.
  int try_flat(int join, double limit);
  int try_layers(double limit);
  /// Makes the swap that was tried last. \pre its count was completed
  void accept();

  /// Lays the tree out anew from its root, which removes the rounding of many moves.
  void refresh();

 private:
  const DualGraph* graph_;
  MovingTree tree_;
  MovingPlaces<FlatSpace> flat_;
  std::vector<MovingPlaces<FoldedSpace>> folded_;
  std::vector<int> order_;  ///< of `folded_`: roughly, those that refuse most swaps first
  int tried_ = -1;
};

}  // namespace foldwright
