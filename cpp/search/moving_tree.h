#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "unfold/spanning_tree.h"

namespace foldwright {

/// A fold tree kept under swaps: one fold is cut, and the smaller side hung at another hinge.
class MovingTree {
 public:
  /// `graph` must outlive this object. \pre `folds` spans it
  MovingTree(const DualGraph& graph, std::span<const int> folds);

  FoldTree folds() const;
  bool is_fold(int hinge) const { return is_fold_[hinge] != 0; }

  /// Folds on the way from panel `a` to panel `b`, in that order, but for those that are never to
  /// be cut.
  void path(int a, int b, std::vector<int>& folds);

  /// Splits the tree at fold `cut` and selects the smaller side as the one to move. Linear in it.
  void select_side(int cut);
  /// The fold that was cut last.
  int cut() const { return cut_; }
  /// Panels of the side that moves.
  std::span<const int> selected() const { return selected_; }
  bool moves(int panel) const { return side_stamp_[panel] == side_; }
  /// Hinges that could replace the cut: all others between the two sides.
  std::span<const int> joins() const { return joins_; }

  /// Begins to list the side that moves from the end of `join` on.
  void list_from(int join);
  /// The side that moves in the order of that list: what hangs near the join comes first, as it is
  /// likeliest to meet the other side. \pre i < selected().size()
  int listed(std::size_t i);

  /// The two ends of a join: the panel that moves, and the one it is hung onto.
  struct Ends {
    int hung, onto;
  };
  Ends ends(int join) const;

  /// Replaces the cut by `join`.
  void accept(int join);

 private:
  /// A hinge of a panel, and the panel on its other side.
  struct Link {
    int hinge, panel;
    bool is_fold;  ///< as `is_fold_` says, closer to hand
  };

  std::span<const Link> links_of(int panel) const {
    const int first = graph_->first_hinge[panel];
    return std::span(links_).subspan(first, graph_->first_hinge[panel + 1] - first);
  }
  void mark_fold(int hinge, bool is_fold);
  /// The end of a fold that hangs from the other one.
  int lower_end(int fold) const;
  void reverse_parents(int from, int to_parent, int join, int size);
  void add_to_sizes(int panel, int change);

  const DualGraph* graph_;
  std::vector<Link> links_;  ///< as `graph_->incident`, closer together than the hinges themselves
  std::vector<int> parent_, parent_fold_;
  std::vector<int> size_;  ///< per panel: panels at or below it
  std::vector<char> is_fold_;
  int cut_ = -1;
  std::vector<int> selected_;
  std::vector<int> joins_;
  /// A panel of the list, and the one that it was reached from.
  struct Listed {
    int panel, from;
  };
  std::vector<Listed> list_;  ///< as far as it was asked for
  std::size_t spread_ = 0;    ///< how many of the list have their neighbours in it
  std::vector<Link> open_;    ///< scratch: of the selected side, all that are no folds
  std::vector<std::uint32_t> side_stamp_;
  std::uint32_t side_ = 0;           ///< stamp of the selected side
  std::vector<std::uint32_t> mark_;  ///< per panel, for paths
  std::uint32_t path_ = 0;
};

}  // namespace foldwright
