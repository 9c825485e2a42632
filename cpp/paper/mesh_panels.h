#pragma once

#include <array>
#include <vector>

#include "mesh/mesh.h"
#include "paper/flap_cover.h"

namespace foldwright {

/// The flat panels of a whole mesh, with their borders: what flaps are hidden by wherever nets are
/// cut.
class MeshPanels {
 public:
  /// Linear.
  explicit MeshPanels(const Mesh& mesh);

  /// The panel of `face` over a base along its border that runs from one vertex of the mesh to
  /// another, with the panel on its right. `scale`: millimetres per model unit. Linear in the
  /// panel's border.
  FlapCover beyond(int face, std::array<int, 2> base, double scale) const;

 private:
  const Mesh* mesh_;
  std::vector<int> panel_of_;  ///< per face
  /// Per panel: edges with the panel on their left.
  std::vector<std::vector<std::array<int, 2>>> borders_;
};

}  // namespace foldwright
