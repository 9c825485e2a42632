#pragma once

#include <vector>

#include "mesh/looks.h"
#include "mesh/mesh.h"

namespace foldwright {

/// Per face its region, named by the lowest of its faces: two are of one region when a way from one
/// to the other crosses no edge where the looks jump. They do where the materials of its faces
/// differ, or the colours or places in the picture that these have at a common vertex. \pre the
/// looks are those of the mesh, corner by corner
std::vector<int> look_regions(const Mesh& mesh, const FaceLooks& looks);

}  // namespace foldwright
