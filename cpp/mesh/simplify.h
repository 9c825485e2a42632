#pragma once

#include "mesh/mesh.h"

namespace foldwright {

struct SimplifyOptions {
  int target_faces = 1000;
};

/// Decimates a mesh to about `target_faces` triangles by edge collapses of least quadric error.
///
/// Manifold stays manifold, closed stays closed, components stay apart, and no collapse turns a
/// normal by more than a right angle. The result may keep more faces than asked for when every
/// further collapse would break that. `source_faces` name the source of the nearest original face.
/// A mesh of at most `target_faces` comes back as it is. Near-linear.
Mesh simplify(const Mesh& mesh, const SimplifyOptions& options = {});

}  // namespace foldwright
