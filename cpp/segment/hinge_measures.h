#pragma once

#include <span>
#include <vector>

#include "mesh/dual_graph.h"

namespace foldwright {

/// Per hinge the way from centroid to midpoint to centroid, in model units.
std::vector<double> hinge_distances(const Mesh& mesh, const DualGraph& graph);

/// Per hinge 1 - cos of its angle, times `convex` for mountains, over the mean of all hinges; 0
/// everywhere on a flat graph.
std::vector<double> hinge_bends(const DualGraph& graph, double convex);

/// Per panel the length of the shortest way over the graph from panel `source`, infinite where
/// there is none. `lengths`: of the hinges, positive. Source: Dijkstra.
std::vector<double> distances_from(const DualGraph& graph, std::span<const double> lengths,
                                   int source);

}  // namespace foldwright
