#pragma once

#include <span>

#include "mesh/mesh.h"

namespace foldwright {

struct SimplifyOptions {
  int target_faces = 1000;
  /// Per face a number: borders between faces of different ones stay where they are, as where two
  /// colours meet. May be empty.
  std::span<const int> regions = {};
  /// Whether a surface that is its own mirror image about some plane stays so.
  bool keep_mirror = false;
  /// Whether faces are kept from running through others.
  bool keep_apart = false;
};

/// Simplifies a mesh to about `target_faces` triangles by collapses of edges.
///
/// Closed stays closed, manifold stays manifold, the genus stays, components stay apart; see
/// `collapse_edges` for the cost of a collapse, and for what is never done. The result may keep
/// more faces than asked for when every further collapse would break that; it is not centred anew.
/// With `keep_mirror` the half of a surface that mirrors itself is simplified, and put together
/// with its image: the result is symmetric to the last bit but for rounding. `source_faces` name
/// the source of the nearest original face. A mesh of at most `target_faces` comes back as it is.
/// Near-linear. \pre `regions` is empty or has a number per face
Mesh simplify(const Mesh& mesh, const SimplifyOptions& options = {});

}  // namespace foldwright
