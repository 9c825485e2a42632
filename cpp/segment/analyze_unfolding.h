#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "unfold/spanning_tree.h"

namespace foldwright {

/// Sources that are analysed together: as many as keep the masks of 1000 panels in a first-level
/// cache.
inline constexpr int kSourceBlock = 256;

/// One bit per source of a block.
using SourceMask = std::array<std::uint64_t, kSourceBlock / 64>;

/// Maximal non-overlapping components of one unfolding, for many sources at once [paper, 4.1.2].
///
/// CC(f) grows from face f breadth first over fold edges, adding a face unless it overlaps a
/// member. A face v is thus a member for source f exactly when its neighbour towards f is one and
/// no member that overlaps v is reached before it. At equal distance the lower panel is reached
/// first. "Towards f" and "before" are sides of tree edges, so the definition is a system of
/// equations over source masks; it is well founded in the distance from f and has one solution,
/// which sweeps up and down the tree find; a sweep looks only where something has changed.
class UnfoldingAnalysis {
 public:
  /// `overlaps`: all overlapping pairs of panels. The tree must outlive this object.
  UnfoldingAnalysis(const RootedTree& tree, std::span<const std::array<int, 2>> overlaps);

  /// Per panel, the sources among panels `first_source`, `first_source + 1`, .. whose component
  /// contains it; bits beyond the last panel are 0. Cost: some sweeps, each linear in panels plus
  /// overlaps.
  void components_of(int first_source, std::vector<SourceMask>& members);

 private:
  /// Overlap partner that blocks a panel for the sources that reach the partner first.
  struct Blocker {
    int panel;
    int side;              ///< panel whose subtree's sources those are,
    std::uint64_t invert;  ///< or, with all bits set, are not
  };

  Blocker make_blocker(int blocker, int blocked) const;
  void fill_subtrees(int first_source);
  void mark_stale(int panel);
  SourceMask equation(int panel, int first_source, const std::vector<SourceMask>& members) const;

  const RootedTree* tree_;
  std::vector<int> depth_;
  std::vector<int> first_child_, children_;
  std::vector<int> first_blocker_;
  std::vector<Blocker> blockers_;
  std::vector<SourceMask> subtree_;  ///< per panel: the block's sources at or below it
  std::vector<char> stale_;          ///< per panel: its equation may not hold any more
};

}  // namespace foldwright
