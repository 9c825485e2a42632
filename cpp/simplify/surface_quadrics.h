#pragma once

#include <optional>
#include <span>
#include <vector>

#include "mesh/mesh.h"
#include "simplify/quadric.h"

namespace foldwright {

/// A plane with the surface on one side of it, whose mirror image will be put on the other side.
struct SymmetryPlane {
  Vec3 normal;  ///< of unit length, towards the surface
  double offset;
  std::vector<bool> is_on;  ///< per vertex, whether it is glued to its own image
};

/// Per vertex what it costs to move it off the surface: squared distances from the planes of its
/// faces, by a third of their areas, and from planes that stand upright on borders, and on edges
/// between faces of different `regions` (a number per face; may be empty), by the edges' lengths.
/// The edges on the plane of symmetry are no border: the surface goes on behind it.
std::vector<Quadric> surface_quadrics(const Mesh& mesh, std::span<const int> regions,
                                      const std::optional<SymmetryPlane>& plane);

}  // namespace foldwright
