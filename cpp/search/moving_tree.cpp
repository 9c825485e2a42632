#include "search/moving_tree.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace foldwright {

MovingTree::MovingTree(const DualGraph& graph, std::span<const int> folds)
    : graph_(&graph),
      size_(graph.panel_count(), 1),
      is_fold_(graph.hinge_count(), 0),
      side_stamp_(graph.panel_count(), 0),
      mark_(graph.panel_count(), 0) {
  links_.reserve(graph.incident.size());
  for (int panel = 0; panel < graph.panel_count(); ++panel) {
    for (const int h : graph.hinges_of(panel)) {
      links_.push_back({h, graph.hinges[h].other(panel), false});
    }
  }
  RootedTree tree = hang_tree(graph, folds);
  for (std::size_t i = tree.order.size(); i-- > 1;) {
    size_[tree.parent[tree.order[i]]] += size_[tree.order[i]];
  }
  parent_ = std::move(tree.parent);
  parent_fold_ = std::move(tree.hinge);
  for (const int h : folds) mark_fold(h, true);
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
  std::erase_if(folds, [&](int fold) { return graph_->hinges[fold].stays_fold; });
}

void MovingTree::mark_fold(int hinge, bool is_fold) {
  is_fold_[hinge] = is_fold ? 1 : 0;
  for (const int panel : graph_->hinges[hinge].panels) {
    for (int i = graph_->first_hinge[panel]; i < graph_->first_hinge[panel + 1]; ++i) {
      if (links_[i].hinge == hinge) links_[i].is_fold = is_fold;
    }
  }
}

int MovingTree::lower_end(int fold) const {
  const auto& [a, b] = graph_->hinges[fold].panels;
  return parent_fold_[a] == fold ? a : b;
}

void MovingTree::select_side(int cut) {
  assert(is_fold_[cut]);
  cut_ = cut;
  const int below = lower_end(cut);
  const bool is_below = 2 * size_[below] <= graph_->panel_count();
  const int start = is_below ? below : parent_[below];
  ++side_;  // a new stamp, so that nothing needs clearing
  selected_.assign(1, start);
  side_stamp_[start] = side_;
  open_.clear();
  for (std::size_t head = 0; head < selected_.size(); ++head) {
    for (const Link& link : links_of(selected_[head])) {
      if (!link.is_fold) {
        open_.push_back(link);
      } else if (link.hinge != cut && !moves(link.panel)) {
        side_stamp_[link.panel] = side_;
        selected_.push_back(link.panel);
      }
    }
  }
  joins_.clear();
  for (const Link& link : open_) {
    if (!moves(link.panel)) joins_.push_back(link.hinge);
  }
}

void MovingTree::list_from(int join) {
  list_.assign(1, {ends(join).hung, -1});
  spread_ = 0;
}

int MovingTree::listed(std::size_t i) {
  while (i >= list_.size()) {
    const auto [panel, from] = list_[spread_++];
    for (const Link& link : links_of(panel)) {
      if (link.is_fold && link.hinge != cut_ && link.panel != from) {
        list_.push_back({link.panel, panel});
      }
    }
  }
  return list_[i].panel;
}

MovingTree::Ends MovingTree::ends(int join) const {
  const Hinge& hinge = graph_->hinges[join];
  const int hung = moves(hinge.panels[0]) ? hinge.panels[0] : hinge.panels[1];
  return {hung, hinge.other(hung)};
}

void MovingTree::accept(int join) {
  const int below = lower_end(cut_);
  // Parents hang below the cut; where that is not the moved side, the join is seen from there.
  const Hinge& hinge = graph_->hinges[join];
  const int hung = moves(hinge.panels[0]) == moves(below) ? hinge.panels[0] : hinge.panels[1];
  mark_fold(cut_, false);
  mark_fold(join, true);
  const int size = size_[below];
  add_to_sizes(parent_[below], -size);
  reverse_parents(hung, hinge.other(hung), join, size);
  add_to_sizes(hinge.other(hung), size);
}

/// Of a panel and all that it hangs from.
void MovingTree::add_to_sizes(int panel, int change) {
  for (; panel != -1; panel = parent_[panel]) size_[panel] += change;
}

/// Hangs the subtree that was cut off by panel `from` instead of its old top. `size`: its panels
void MovingTree::reverse_parents(int from, int to_parent, int join, int size) {
  int panel = from;
  int parent = to_parent;
  int fold = join;
  int before = 0;  // panels below the one before, which now hangs above
  while (fold != cut_) {
    const int old_parent = parent_[panel];
    const int old_fold = parent_fold_[panel];
    before = std::exchange(size_[panel], size - before);
    parent_[panel] = parent;
    parent_fold_[panel] = fold;
    parent = panel;
    fold = old_fold;
    panel = old_parent;
  }
}

}  // namespace foldwright
