#include "search/moving_tree.h"

#include <algorithm>
#include <cassert>

namespace foldwright {

MovingTree::MovingTree(const DualGraph& graph, std::span<const int> folds)
    : graph_(&graph),
      is_fold_(graph.hinge_count(), 0),
      side_stamp_(graph.panel_count(), 0),
      mark_(graph.panel_count(), 0) {
  RootedTree tree = hang_tree(graph, folds);
  parent_ = std::move(tree.parent);
  parent_fold_ = std::move(tree.hinge);
  for (const int h : folds) is_fold_[h] = 1;
}

FoldTree MovingTree::folds() const {
  FoldTree folds;
  for (int h = 0; h < graph_->hinge_count(); ++h) {
    if (is_fold_[h]) folds.push_back(h);
  }
  return folds;
}

void MovingTree::path(int a, int b, std::vector<int>& folds) {
  ++path_;
  for (int panel = a; panel != -1; panel = parent_[panel]) mark_[panel] = path_;
  folds.clear();
  int meet = b;
  for (; mark_[meet] != path_; meet = parent_[meet]) folds.push_back(parent_fold_[meet]);
  const auto from_b = static_cast<std::ptrdiff_t>(folds.size());
  for (int panel = a; panel != meet; panel = parent_[panel]) folds.push_back(parent_fold_[panel]);
  // Collected as b .. meet, a .. meet; wanted is a .. meet .. b.
  std::reverse(folds.begin(), folds.begin() + from_b);
  std::rotate(folds.begin(), folds.begin() + from_b, folds.end());
}

void MovingTree::select_side(int cut) {
  assert(is_fold_[cut]);
  cut_ = cut;
  // Two breadth-first searches in turn; the one that runs dry first has found the smaller side.
  // Each search has a new stamp, so nothing needs clearing.
  const std::uint32_t stamps[2] = {next_side_ + 1, next_side_ + 2};
  next_side_ += 2;
  std::vector<int>* sides[2] = {&selected_, &other_side_};
  std::size_t heads[2] = {0, 0};
  for (int s = 0; s < 2; ++s) {
    const int start = graph_->hinges[cut].panels[s];
    sides[s]->assign(1, start);
    side_stamp_[start] = stamps[s];
  }
  int smaller = -1;
  for (int s = 0; smaller == -1; s = 1 - s) {
    const int panel = (*sides[s])[heads[s]++];
    for (const int h : graph_->hinges_of(panel)) {
      if (!is_fold_[h] || h == cut) continue;
      const int next = graph_->hinges[h].other(panel);
      if (side_stamp_[next] == stamps[s]) continue;
      side_stamp_[next] = stamps[s];
      sides[s]->push_back(next);
    }
    if (heads[s] == sides[s]->size()) smaller = s;
  }
  if (smaller == 1) std::swap(selected_, other_side_);
  side_ = stamps[smaller];

  joins_.clear();
  for (const int panel : selected_) {
    for (const int h : graph_->hinges_of(panel)) {
      if (h != cut && !is_fold_[h] && !moves(graph_->hinges[h].other(panel))) joins_.push_back(h);
    }
  }
}

MovingTree::Ends MovingTree::ends(int join) const {
  const Hinge& hinge = graph_->hinges[join];
  const int hung = moves(hinge.panels[0]) ? hinge.panels[0] : hinge.panels[1];
  return {hung, hinge.other(hung)};
}

void MovingTree::accept(int join) {
  const Hinge& cut = graph_->hinges[cut_];
  const int below = parent_fold_[cut.panels[0]] == cut_ ? cut.panels[0] : cut.panels[1];
  // Parents hang below the cut; where that is not the moved side, the join is seen from there.
  const Hinge& hinge = graph_->hinges[join];
  const int hung = moves(hinge.panels[0]) == moves(below) ? hinge.panels[0] : hinge.panels[1];
  is_fold_[cut_] = 0;
  is_fold_[join] = 1;
  reverse_parents(hung, hinge.other(hung), join);
}

/// Hangs the subtree that was cut off by panel `from` instead of its old top.
void MovingTree::reverse_parents(int from, int to_parent, int join) {
  int panel = from;
  int parent = to_parent;
  int fold = join;
  while (fold != cut_) {
    const int old_parent = parent_[panel];
    const int old_fold = parent_fold_[panel];
    parent_[panel] = parent;
    parent_fold_[panel] = fold;
    parent = panel;
    fold = old_fold;
    panel = old_parent;
  }
}

}  // namespace foldwright
