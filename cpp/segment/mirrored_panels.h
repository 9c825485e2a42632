#pragma once

#include <vector>

#include "mesh/dual_graph.h"
#include "mesh/mirror.h"

namespace foldwright {

/// Per panel the one that lies where its mirror image is: of all panels nearest to the images of
/// its faces the one with most of their area. Not always an involution.
std::vector<int> mirrored_panels(const Mesh& mesh, const DualGraph& graph, const Mirror& mirror);

}  // namespace foldwright
