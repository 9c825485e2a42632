#pragma once

#include <optional>
#include <vector>

#include "mesh/mirror.h"
#include "simplify/edge_collapse.h"

namespace foldwright {

/// Whether a whole surface is its own mirror image: no vertex's image lies further from it than
/// half a percent of the diagonal of its box. n log n.
bool mirrors_itself(const Mesh& mesh, const Mirror& mirror);

/// The half of a surface on one side of a plane.
struct MirrorHalf {
  Mesh mesh;  ///< `source_faces`: the face of the whole mesh that each was cut from
  SymmetryPlane plane;
};

/// Cuts a surface by a plane and keeps what is in front of it. Vertices very near to the plane are
/// moved onto it. None when the half cannot be glued to its image: a face lies in the plane, or an
/// edge in it has both its faces in front.
std::optional<MirrorHalf> half_in_front(const Mesh& mesh, const Mirror& mirror);

/// A half and its mirror image as one mesh, glued where the half lies on the plane.
Mesh with_image(const CollapsedMesh& half, const SymmetryPlane& plane);

}  // namespace foldwright
