#pragma once

#include <vector>

#include "mesh/mesh.h"

namespace foldwright {

/// For each face of `from`, the face of `to` that lies nearest to its centroid and faces the same
/// way: least squared distance plus 0.1 (1 - n.n'), in units of `to`'s mean edge (the normal term
/// keeps the two sides of thin sheets apart). Carries labels between resolutions of one surface.
/// Of equally near ones the lower. About |from| log |to|. \pre `to` has a face
std::vector<int> nearest_faces(const Mesh& from, const Mesh& to);

}  // namespace foldwright
