#pragma once

#include <vector>

#include "mesh/dual_graph.h"

namespace foldwright {

/// Per vertex of the mesh, whether its face angles add up to more than a full turn: negative
/// Gaussian curvature, where one cut cannot flatten the faces around it [paper, 4.3].
std::vector<char> hyperbolic_vertices(const Mesh& mesh);

/// Vertices of the faces of each panel, ascending.
std::vector<std::vector<int>> panel_vertices(const Mesh& mesh, const DualGraph& graph);

/// Of those, the hyperbolic ones that lie inside the graph: all faces around them belong to it.
std::vector<std::vector<int>> hyperbolic_vertices_of_panels(const Mesh& mesh,
                                                            const DualGraph& graph);

}  // namespace foldwright
