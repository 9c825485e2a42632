#include "search/moving_layout.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>

namespace foldwright {
namespace {

// An item over more cells than this goes to the list that every query reads.
constexpr std::int64_t kMostCells = 64;

double mean_box_size(std::span<const Triangle2> triangles) {
  double sum = 0;
  for (const Triangle2& triangle : triangles) {
    const Box2 box = box_of(triangle);
    sum += (box.max_x - box.min_x) + (box.max_y - box.min_y);
  }
  return 0.5 * sum / static_cast<double>(triangles.size());
}

}  // namespace

BoxGrid::BoxGrid(int capacity, double cell)
    : per_cell_(1 / cell),
      mask_(std::bit_ceil(static_cast<std::size_t>(4 * capacity)) - 1),
      buckets_(mask_ + 1) {}

BoxGrid::Range BoxGrid::cells_of(const Box2& box) const {
  const auto cell = [&](double x) { return static_cast<std::int64_t>(std::floor(x * per_cell_)); };
  return {cell(box.min_x), cell(box.min_y), cell(box.max_x), cell(box.max_y)};
}

std::size_t BoxGrid::bucket(std::int64_t x, std::int64_t y) const {
  // Two odd constants near 2^64 over the golden ratio and its square scatter neighbouring cells.
  const auto mixed = static_cast<std::uint64_t>(x) * 0x9e3779b97f4a7c15ull +
                     static_cast<std::uint64_t>(y) * 0xd1b54a32d192ed03ull;
  return static_cast<std::size_t>(mixed >> 32) & mask_;
}

void BoxGrid::insert(int item, const Box2& box) {
  const Range range = cells_of(box);
  if (range.cells() > kMostCells) {
    large_.push_back(item);
    return;
  }
  for (std::int64_t y = range.min_y; y <= range.max_y; ++y) {
    for (std::int64_t x = range.min_x; x <= range.max_x; ++x)
      buckets_[bucket(x, y)].push_back(item);
  }
}

void BoxGrid::remove(int item, const Box2& box) {
  const auto erase_one = [item](std::vector<int>& list) {
    const auto at = std::find(list.begin(), list.end(), item);
    assert(at != list.end());
    *at = list.back();
    list.pop_back();
  };
  const Range range = cells_of(box);
  if (range.cells() > kMostCells) {
    erase_one(large_);
    return;
  }
  for (std::int64_t y = range.min_y; y <= range.max_y; ++y) {
    for (std::int64_t x = range.min_x; x <= range.max_x; ++x) erase_one(buckets_[bucket(x, y)]);
  }
}

MovingLayout::MovingLayout(const DualGraph& graph, std::span<const int> folds)
    : graph_(&graph),
      tolerance_(kOverlapTolerance * graph.unit),
      is_fold_(graph.hinge_count(), 0),
      panel_of_(graph.triangles.size()),
      triangles_(graph.triangles),
      boxes_(graph.triangles.size()),
      grid_(static_cast<int>(graph.triangles.size()), mean_box_size(graph.triangles)),
      partners_(graph.panel_count()),
      conflict_slot_(graph.panel_count(), -1),
      side_stamp_(graph.panel_count(), 0),
      seen_(graph.triangles.size(), 0),
      mark_(graph.panel_count(), 0) {
  RootedTree tree = hang_tree(graph, folds);
  layout_ = lay_out(graph, tree);
  parent_ = std::move(tree.parent);
  parent_fold_ = std::move(tree.hinge);
  for (const int h : folds) is_fold_[h] = 1;
  for (int panel = 0; panel < graph.panel_count(); ++panel) {
    for (int i = graph.first_face[panel]; i < graph.first_face[panel + 1]; ++i) {
      panel_of_[i] = panel;
      triangles_[i] = moved(layout_[panel], graph.triangles[i]);
      boxes_[i] = box_of(triangles_[i]);
      grid_.insert(i, boxes_[i]);
    }
  }
  for (const auto& [a, b] : overlapping_panels(graph, layout_)) add_overlap(a, b);
}

FoldTree MovingLayout::folds() const {
  FoldTree folds;
  for (int h = 0; h < graph_->hinge_count(); ++h) {
    if (is_fold_[h]) folds.push_back(h);
  }
  return folds;
}

void MovingLayout::add_overlap(int a, int b) {
  for (const auto& [panel, partner] : {std::array{a, b}, std::array{b, a}}) {
    if (partners_[panel].empty()) {
      conflict_slot_[panel] = static_cast<int>(conflicted_.size());
      conflicted_.push_back(panel);
    }
    partners_[panel].push_back(partner);
  }
  ++overlap_count_;
}

void MovingLayout::forget_partner(int panel, int partner) {
  std::vector<int>& list = partners_[panel];
  *std::find(list.begin(), list.end(), partner) = list.back();
  list.pop_back();
  if (!list.empty()) return;
  const int last = conflicted_.back();
  conflicted_[conflict_slot_[panel]] = last;
  conflict_slot_[last] = conflict_slot_[panel];
  conflicted_.pop_back();
}

void MovingLayout::remove_overlap(int a, int b) {
  forget_partner(a, b);
  forget_partner(b, a);
  --overlap_count_;
}

void MovingLayout::path(int a, int b, std::vector<int>& folds) {
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

void MovingLayout::select_side(int cut) {
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
  crossing_ = 0;
  for (const int panel : selected_) {
    for (const int h : graph_->hinges_of(panel)) {
      if (h != cut && !is_fold_[h] && !moves(graph_->hinges[h].other(panel))) joins_.push_back(h);
    }
    for (const int partner : partners_[panel]) crossing_ += moves(partner) ? 0 : 1;
  }
}

int MovingLayout::try_join(int join, double limit) {
  const Hinge& hinge = graph_->hinges[join];
  const int hung = moves(hinge.panels[0]) ? hinge.panels[0] : hinge.panels[1];
  const int onto = hinge.other(hung);
  assert(moves(hung) && !moves(onto));
  trial_.join = join;
  trial_.motion = layout_[onto] * graph_->lay_beside(join, hung) * layout_[hung].inverse();
  trial_.overlaps.clear();
  for (const int panel : selected_) {
    if (!count_panel(panel, limit)) break;
  }
  return static_cast<int>(trial_.overlaps.size());
}

bool MovingLayout::count_panel(int panel, double limit) {
  const auto first_of_panel = static_cast<std::ptrdiff_t>(trial_.overlaps.size());
  for (int i = graph_->first_face[panel]; i < graph_->first_face[panel + 1]; ++i) {
    const Triangle2 triangle = moved(trial_.motion, triangles_[i]);
    const Box2 box = box_of(triangle);
    ++query_;
    bool within = true;
    grid_.visit(box, [&](int other) {
      if (seen_[other] == query_) return true;
      seen_[other] = query_;
      const int partner = panel_of_[other];
      if (moves(partner) || !box.meets(boxes_[other])) return true;
      if (!triangles_overlap(triangle, triangles_[other], tolerance_)) return true;
      // Panels of several triangles may meet more than once.
      const std::array<int, 2> pair = {panel, partner};
      if (std::find(trial_.overlaps.begin() + first_of_panel, trial_.overlaps.end(), pair) !=
          trial_.overlaps.end()) {
        return true;
      }
      trial_.overlaps.push_back(pair);
      within = static_cast<double>(trial_.overlaps.size()) <= limit;
      return within;
    });
    if (!within) return false;
  }
  return true;
}

void MovingLayout::accept() {
  for (const int panel : selected_) {
    // Backwards, because removing replaces an entry by the last one.
    for (auto i = static_cast<int>(partners_[panel].size()) - 1; i >= 0; --i) {
      const int partner = partners_[panel][i];
      if (!moves(partner)) remove_overlap(panel, partner);
    }
  }
  for (const auto& [panel, partner] : trial_.overlaps) add_overlap(panel, partner);
  for (const int panel : selected_) move_panel(panel, trial_.motion * layout_[panel]);

  const Hinge& cut = graph_->hinges[cut_];
  const int below = parent_fold_[cut.panels[0]] == cut_ ? cut.panels[0] : cut.panels[1];
  // Parents hang below the cut; where that is not the moved side, the join is seen from there.
  const Hinge& join = graph_->hinges[trial_.join];
  const int hung = moves(join.panels[0]) == moves(below) ? join.panels[0] : join.panels[1];
  is_fold_[cut_] = 0;
  is_fold_[trial_.join] = 1;
  reverse_parents(hung, join.other(hung), trial_.join);
}

/// Hangs the subtree that was cut off by panel `from` instead of its old top.
void MovingLayout::reverse_parents(int from, int to_parent, int join) {
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

void MovingLayout::move_panel(int panel, const RigidMotion2& place) {
  layout_[panel] = place;
  for (int i = graph_->first_face[panel]; i < graph_->first_face[panel + 1]; ++i) {
    grid_.remove(i, boxes_[i]);
    triangles_[i] = moved(place, graph_->triangles[i]);
    boxes_[i] = box_of(triangles_[i]);
    grid_.insert(i, boxes_[i]);
  }
}

void MovingLayout::refresh() { *this = MovingLayout(*graph_, folds()); }

}  // namespace foldwright
