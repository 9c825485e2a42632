#pragma once

#include <string>

#include "segment/foldability.h"
#include "segment/labels.h"

/// Learned surfaces and their parts, shared by the tests of segmentation and search.
namespace foldwright::testing {

/// A surface to be unfolded, with its dual graph.
struct Unfoldable {
  Mesh mesh;
  DualGraph graph;
};

Unfoldable unfoldable(Mesh mesh);

/// What is learned from `runs` unfoldings by steepest edge.
FoldabilityMatrix learn(const Unfoldable& surface, int runs);

/// What is wrong with labels: a panel without one, a gap in the numbers, a part in several pieces.
/// Empty when nothing is.
std::string fault_of_parts(const DualGraph& graph, const Labels& labels);

}  // namespace foldwright::testing
