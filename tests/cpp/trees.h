#pragma once

#include <vector>

#include "geometry/random.h"
#include "unfold/net.h"

/// Fold trees for tests, made by other means than the engine's.
namespace foldwright::testing {

/// Every spanning tree of a small graph, in lexicographic order. Exponential: \pre few hinges
std::vector<FoldTree> all_spanning_trees(const DualGraph& graph);

/// Spanning tree of random weights.
FoldTree random_tree(const DualGraph& graph, Random& random);

/// Overlapping pairs of a fold tree laid flat.
std::vector<std::array<int, 2>> overlaps_of(const DualGraph& graph, const FoldTree& folds);

/// Whether a fold tree is a net, checked by other means than the search.
bool is_net(const Mesh& mesh, const DualGraph& graph, const FoldTree& folds);

}  // namespace foldwright::testing
