#pragma once

#include <span>
#include <vector>

#include "mesh/dual_graph.h"

namespace foldwright {

/// An unfolding as the hinges it keeps: a spanning tree of the dual graph, ascending. Every other
/// hinge is cut [paper, 3.1].
using FoldTree = std::vector<int>;

/// Minimum spanning tree of the dual graph; ties go to the lower hinge. Hinges that are never to be
/// cut come before all others.
/// `weights`: one finite value per hinge. \pre graph is connected
FoldTree minimum_spanning_tree(const DualGraph& graph, std::span<const double> weights);

/// A fold tree hung from a root.
struct RootedTree {
  std::vector<int> order;   ///< panels, breadth first from the root
  std::vector<int> parent;  ///< per panel; -1 at the root
  std::vector<int> hinge;   ///< per panel: hinge to its parent; -1 at the root
};

/// \pre `folds` spans the graph
RootedTree hang_tree(const DualGraph& graph, std::span<const int> folds, int root = 0);

/// The panel from which the farthest other one is the fewest folds away; of two the lower. Linear.
/// \pre `folds` spans the graph
int tree_centre(const DualGraph& graph, std::span<const int> folds);

}  // namespace foldwright
