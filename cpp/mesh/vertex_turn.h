#pragma once

#include <span>
#include <vector>

#include "mesh/mesh.h"

namespace foldwright {

/// Per vertex of the mesh the sum of the angles that some faces have there, in radians: around an
/// inner vertex, 2 pi less its Gaussian curvature.
std::vector<double> vertex_turns(const Mesh& mesh, std::span<const int> faces);

/// The same over all faces.
std::vector<double> vertex_turns(const Mesh& mesh);

}  // namespace foldwright
