#pragma once

#include <optional>
#include <span>
#include <vector>

#include "mesh/mesh.h"
#include "simplify/surface_quadrics.h"

namespace foldwright {

struct CollapseOptions {
  int target_faces;
  /// Per face a number: borders between faces of different ones stay where they are. May be empty.
  std::span<const int> regions = {};
  /// Vertices on it stay on it, all others on its side of it.
  std::optional<SymmetryPlane> plane = std::nullopt;
  /// Whether faces are kept from running through others.
  bool keep_apart = true;
};

struct CollapsedMesh {
  std::vector<Vec3> positions;
  std::vector<std::array<int, 3>> faces;
  std::vector<bool> is_on_plane;  ///< per vertex; empty without a plane
};

/// Collapses edges in the order of their cost until a mesh has `target_faces` faces: quadric error
/// of the best place of the vertex that comes of it (Garland, Heckbert 1997), borders and edges
/// between regions weighted in, and what the shapes of the faces around it cost more or less than
/// before (`shape_cost`).
///
/// Closed stays closed, manifold manifold, the genus as it is, components apart. No collapse turns
/// a face by more than some 70 degrees. With `keep_apart` no face comes to run through another one
/// that it did not run through before, by more than a touch, once there are so few that looking
/// costs little (30,000). There may be more faces than asked for where no other collapse is
/// allowed. `source_faces` are not carried over. Near-linear, deterministic.
CollapsedMesh collapse_edges(const Mesh& mesh, const CollapseOptions& options);

}  // namespace foldwright
