#pragma once

#include <span>
#include <vector>

#include "mesh/dual_graph.h"

namespace foldwright {

/// A fold shorter than this holds no more than a few faces: paper tears there. In mm.
inline constexpr double kNeckLength = 5;

/// Faces on both sides of a fold from which on it holds more than a few.
inline constexpr int kNeckFaces = 8;

/// The necks of a net: folds that are too short for what hangs at them, ascending.
///
/// `is_fold`: per hinge of the graph, whether it is one of the net's folds. `scale`: millimetres
/// per model unit. Linear. \pre the folds span the graph
std::vector<int> find_necks(const DualGraph& graph, std::span<const char> is_fold, double scale);

}  // namespace foldwright
