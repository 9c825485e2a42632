#pragma once

#include <vector>

#include "mesh/dual_graph.h"

namespace foldwright {

/// Distances between all panels over the dual graph, long where the way crosses concave edges.
///
/// A hinge is as long as 0.1 of its relative geodesic length (centroid to midpoint to centroid)
/// plus 0.9 of its relative bend eta (1 - cos theta), eta = 1 if concave and 0.05 if convex.
/// Divided by the mean over reachable pairs; unreachable pairs get a large finite value. Row-major
/// n x n. Source: Katz and Tal 2003, with the weights measured on the Princeton benchmark.
std::vector<float> concave_geodesic(const Mesh& mesh, const DualGraph& graph);

}  // namespace foldwright
