#pragma once

#include "unfold/spanning_tree.h"

namespace foldwright {

/// Index into `folds` of the fold that parts most of the overlapping pairs of panels when it is
/// cut; of several the one that leaves the most even halves. Folds that are never to be cut are
/// left out. \pre `folds` spans the graph, and one of them may be cut
int best_overlap_cut(const DualGraph& graph, const FoldTree& folds);

}  // namespace foldwright
