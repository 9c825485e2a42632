#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "unfold/layout.h"

namespace foldwright {

/// Hash grid over moving boxes: finds those that may meet a given one.
class BoxGrid {
 public:
  /// `cell`: edge length of a cell, about the size of a usual box.
  BoxGrid(int capacity, double cell);

  void insert(int item, const Box2& box);
  void remove(int item, const Box2& box);

  /// Calls `visit(item)` for every item that shares a cell with `box`, some several times, until
  /// it returns false.
  template <class Visit>
  void visit(const Box2& box, Visit&& visit) const {
    for (const int item : large_) {
      if (!visit(item)) return;
    }
    const Range range = cells_of(box);
    for (std::int64_t y = range.min_y; y <= range.max_y; ++y) {
      for (std::int64_t x = range.min_x; x <= range.max_x; ++x) {
        for (const int item : buckets_[bucket(x, y)]) {
          if (!visit(item)) return;
        }
      }
    }
  }

 private:
  struct Range {
    std::int64_t min_x, min_y, max_x, max_y;
    std::int64_t cells() const { return (max_x - min_x + 1) * (max_y - min_y + 1); }
  };

  Range cells_of(const Box2& box) const;
  std::size_t bucket(std::int64_t x, std::int64_t y) const;

  double per_cell_;
  std::size_t mask_;
  std::vector<std::vector<int>> buckets_;
  std::vector<int> large_;  ///< items over so many cells that listing them in all would not pay
};

/// Replaces fold `cut` by fold `join`; the panels on one side of the cut move with it.
struct Swap {
  int cut = -1;
  int join = -1;
};

/// A fold tree laid flat, kept under swaps of its folds: places, overlaps, parents.
///
/// A swap moves one side of the tree rigidly, so only overlaps between the sides change. The
/// smaller side is moved. Cost of a trial: linear in that side.
class MovingLayout {
 public:
  /// Both must outlive this object. \pre `folds` spans the graph
  MovingLayout(const DualGraph& graph, std::span<const int> folds);

  int overlap_count() const { return overlap_count_; }
  FoldTree folds() const;

  /// Panels that overlap some other, in no particular (but reproducible) order.
  std::span<const int> conflicted() const { return conflicted_; }
  std::span<const int> partners(int panel) const { return partners_[panel]; }

  /// Folds on the way from panel `a` to panel `b`, in that order.
  void path(int a, int b, std::vector<int>& folds);

  /// Splits the tree at fold `cut` and selects the smaller side as the one to move.
  void select_side(int cut);
  /// Hinges that could replace the cut: all others between the two sides.
  std::span<const int> joins() const { return joins_; }
  int selected_size() const { return static_cast<int>(selected_.size()); }
  /// Overlaps between the two sides as they lie now.
  int crossing_overlaps() const { return crossing_; }

  /// Overlaps between the sides if the selected one were hung at `join`; stops counting above
  /// `limit` and then returns more than it.
  int try_join(int join, double limit);
  /// Makes the swap that was tried last. \pre its count was completed
  void accept();

  /// Lays the tree out anew from its root, which removes the rounding of many moves.
  void refresh();

 private:
  struct Trial {
    int join;
    RigidMotion2 motion;
    std::vector<std::array<int, 2>> overlaps;  ///< (moved panel, panel that stays)
  };

  void add_overlap(int a, int b);
  void remove_overlap(int a, int b);
  void forget_partner(int panel, int partner);
  bool moves(int panel) const { return side_stamp_[panel] == side_; }
  /// Counts what one panel meets when moved; false when `limit` is exceeded.
  bool count_panel(int panel, double limit);
  void reverse_parents(int from, int to_parent, int join);
  void move_panel(int panel, const RigidMotion2& place);

  const DualGraph* graph_;
  double tolerance_;
  std::vector<int> parent_, parent_fold_;
  std::vector<char> is_fold_;
  Layout layout_;
  std::vector<int> panel_of_;         ///< per triangle
  std::vector<Triangle2> triangles_;  ///< placed
  std::vector<Box2> boxes_;
  BoxGrid grid_;
  std::vector<std::vector<int>> partners_;
  std::vector<int> conflicted_, conflict_slot_;
  int overlap_count_ = 0;

  int cut_ = -1;
  int crossing_ = 0;
  std::vector<int> selected_;  ///< panels of the side that moves
  std::vector<int> joins_;
  std::vector<std::uint32_t> side_stamp_;
  std::uint32_t side_ = 0;           ///< stamp of the selected side
  std::uint32_t next_side_ = 0;      ///< last stamp given out
  std::vector<std::uint32_t> seen_;  ///< per triangle, within one query
  std::uint32_t query_ = 0;
  std::vector<std::uint32_t> mark_;  ///< per panel, for paths
  std::uint32_t path_ = 0;
  std::vector<int> other_side_;
  Trial trial_;
};

}  // namespace foldwright
