#pragma once

#include <vector>

#include "mesh/mesh.h"

namespace foldwright {

/// The joints of a mesh: every border edge that connects the same two places as another edge.
///
/// An edge of more than two faces came apart when the mesh was made manifold: a fin on a box, three
/// walls that meet. What stands there is glued to the other edge all the same. Its host is the edge
/// there that has two faces, or else the first of the borders, which then is no joint itself.
/// Closed bodies that share an edge have none, while the two banks of a one-sided surface that was
/// cut open are one. Edges of which one side only was halved are not found. Sorted by edge; n log
/// n.
std::vector<Joint> find_joints(const Mesh& mesh);

}  // namespace foldwright
