#include "segment/analyze_unfolding.h"

#include <algorithm>

namespace foldwright {
namespace {

constexpr int kWords = kSourceBlock / 64;

/// Offsets of a CSR from its row sizes.
void accumulate(std::vector<int>& first) {
  for (std::size_t i = 1; i < first.size(); ++i) first[i] += first[i - 1];
}

}  // namespace

UnfoldingAnalysis::UnfoldingAnalysis(const RootedTree& tree,
                                     std::span<const std::array<int, 2>> overlaps)
    : tree_(&tree) {
  const int n = static_cast<int>(tree.order.size());
  depth_.assign(n, 0);
  first_child_.assign(n + 1, 0);
  for (const int panel : tree.order) {
    if (tree.parent[panel] == -1) continue;
    depth_[panel] = depth_[tree.parent[panel]] + 1;
    ++first_child_[tree.parent[panel] + 1];
  }
  accumulate(first_child_);
  children_.resize(n - 1);
  std::vector<int> next(first_child_.begin(), first_child_.end() - 1);
  for (const int panel : tree.order) {
    if (tree.parent[panel] != -1) children_[next[tree.parent[panel]]++] = panel;
  }

  first_blocker_.assign(n + 1, 0);
  for (const auto& [a, b] : overlaps) ++first_blocker_[a + 1], ++first_blocker_[b + 1];
  accumulate(first_blocker_);
  blockers_.resize(2 * overlaps.size());
  next.assign(first_blocker_.begin(), first_blocker_.end() - 1);
  for (const auto& [a, b] : overlaps) {
    blockers_[next[a]++] = make_blocker(b, a);
    blockers_[next[b]++] = make_blocker(a, b);
  }
}

/// Cuts the tree path between the two in its middle; the sources on the blocker's side reach it
/// first. With a middle panel instead of a middle edge, that panel's branches go to the lower end.
UnfoldingAnalysis::Blocker UnfoldingAnalysis::make_blocker(int blocker, int blocked) const {
  int a = blocker;
  int b = blocked;
  int climbed_a = 0;
  int climbed_b = 0;
  while (a != b) {
    if (depth_[a] >= depth_[b]) {
      a = tree_->parent[a];
      ++climbed_a;
    } else {
      b = tree_->parent[b];
      ++climbed_b;
    }
  }
  const int length = climbed_a + climbed_b;
  // Panels on the path that the blocker reaches first, counted from its end.
  const int own = length % 2 == 1 ? (length + 1) / 2 : length / 2 + (blocker < blocked ? 1 : 0);
  const bool below = own <= climbed_a;  // the dividing edge lies on the blocker's leg
  int top = below ? blocker : blocked;
  for (int step = (below ? own : length + 1 - own) - 1; step > 0; --step) top = tree_->parent[top];
  return {blocker, top, below ? 0 : ~std::uint64_t{0}};
}

void UnfoldingAnalysis::fill_subtrees(int first_source) {
  const int n = static_cast<int>(depth_.size());
  subtree_.assign(n, SourceMask{});
  for (int i = 0; i < kSourceBlock && first_source + i < n; ++i) {
    subtree_[first_source + i][i / 64] |= std::uint64_t{1} << (i % 64);
  }
  for (int i = n - 1; i > 0; --i) {
    const int panel = tree_->order[i];
    SourceMask& parent = subtree_[tree_->parent[panel]];
    for (int w = 0; w < kWords; ++w) parent[w] |= subtree_[panel][w];
  }
}

SourceMask UnfoldingAnalysis::equation(int panel, int first_source,
                                       const std::vector<SourceMask>& members) const {
  SourceMask reached{};
  SourceMask blocked{};
  if (const int parent = tree_->parent[panel]; parent != -1) {
    for (int w = 0; w < kWords; ++w) reached[w] = members[parent][w] & ~subtree_[panel][w];
  }
  for (int i = first_child_[panel]; i < first_child_[panel + 1]; ++i) {
    const int child = children_[i];
    for (int w = 0; w < kWords; ++w) reached[w] |= members[child][w] & subtree_[child][w];
  }
  for (int i = first_blocker_[panel]; i < first_blocker_[panel + 1]; ++i) {
    const Blocker& by = blockers_[i];
    for (int w = 0; w < kWords; ++w) {
      blocked[w] |= members[by.panel][w] & (subtree_[by.side][w] ^ by.invert);
    }
  }
  for (int w = 0; w < kWords; ++w) reached[w] &= ~blocked[w];
  if (const int self = panel - first_source; self >= 0 && self < kSourceBlock) {
    reached[self / 64] |= std::uint64_t{1} << (self % 64);
  }
  return reached;
}

void UnfoldingAnalysis::components_of(int first_source, std::vector<SourceMask>& members) {
  fill_subtrees(first_source);
  const int n = static_cast<int>(depth_.size());
  members.assign(n, subtree_[tree_->order[0]]);  // every source of the block, everywhere
  stale_.assign(n, 1);
  bool changed = true;
  for (int sweep = 0; changed; ++sweep) {
    changed = false;
    for (int i = 0; i < n; ++i) {
      const int panel = tree_->order[sweep % 2 == 0 ? i : n - 1 - i];
      if (!stale_[panel]) continue;
      stale_[panel] = 0;
      const SourceMask mask = equation(panel, first_source, members);
      if (mask == members[panel]) continue;
      members[panel] = mask;
      mark_stale(panel);
      changed = true;
    }
  }
}

/// Marks the panels whose equations have this one's members on their right side.
void UnfoldingAnalysis::mark_stale(int panel) {
  if (const int parent = tree_->parent[panel]; parent != -1) stale_[parent] = 1;
  for (int i = first_child_[panel]; i < first_child_[panel + 1]; ++i) stale_[children_[i]] = 1;
  for (int i = first_blocker_[panel]; i < first_blocker_[panel + 1]; ++i) {
    stale_[blockers_[i].panel] = 1;  // overlapping is mutual
  }
}

}  // namespace foldwright
