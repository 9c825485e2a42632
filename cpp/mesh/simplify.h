#pragma once

#include "mesh/mesh.h"

namespace foldwright {

struct SimplifyOptions {
  int target_faces = 1000;
};

/// Decimates a mesh to about `target_faces` triangles by edge collapses of least quadric error.
///
/// Manifold stays manifold, closed stays closed, components stay apart, and no collapse turns a
/// normal by more than a right angle. How far a border moves counts as error too, so that sheets
/// keep their corners. The result may keep more faces than asked for when every further collapse
/// would break that; it is not centred anew. `source_faces` name the source of the nearest original
/// face. A mesh of at most `target_faces` comes back as it is. Near-linear.
/// Source: Garland, Heckbert 1997, with half-edge collapses.
Mesh simplify(const Mesh& mesh, const SimplifyOptions& options = {});

}  // namespace foldwright
