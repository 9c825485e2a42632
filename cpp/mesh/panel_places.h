#pragma once

#include <vector>

#include "mesh/dual_graph.h"

namespace foldwright {

/// Where a panel is in space.
struct PanelPlace {
  Vec3 centroid;  ///< model units
  Vec3 normal;    ///< of unit length, outwards
};

/// The places of all panels of a graph over `mesh`. Linear.
std::vector<PanelPlace> panel_places(const Mesh& mesh, const DualGraph& graph);

}  // namespace foldwright
