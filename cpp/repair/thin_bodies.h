#pragma once

#include "mesh/mesh.h"

namespace foldwright {

/// Numbers of bodies that enclose no volume.
struct ThinBodies {
  int open = 0;  ///< surfaces with a border
  int flat = 0;  ///< closed ones, whose layers lie on each other
};

/// Counts the bodies that are surfaces without a thickness: those with a border, and closed ones
/// that are no thicker than twice `tolerance`, in model units. Linear time.
ThinBodies find_thin_bodies(const Mesh& mesh, double tolerance);

}  // namespace foldwright
