#pragma once

#include "mesh/mesh.h"

namespace foldwright {

/// Bodies (components of a mesh) that run through each other or themselves.
struct Crossings {
  int pairs = 0;        ///< of bodies that run through each other
  int bodies = 0;       ///< that run through themselves
  bool checked = true;  ///< false when the mesh is too large to look
};

/// Looks for faces that cross by more than a thousandth of the model's extent, or a tenth of their
/// own size. Bodies that touch, in whatever way, or that lie within each other do not cross.
/// Near-linear; meshes of more than 200,000 faces are not looked at, which would take seconds.
Crossings find_crossings(const Mesh& mesh);

}  // namespace foldwright
