#pragma once

#include <optional>
#include <span>

#include "mesh/mesh.h"

namespace foldwright {

/// A plane that a surface is nearly symmetric about.
struct Mirror {
  Vec3 normal;    ///< of unit length
  double offset;  ///< the plane is where normal . p = offset, in model units
  /// Mean distance of the surface's mirror image from the surface, over the root mean square
  /// distance of the surface from its centroid.
  double error;

  Vec3 image(const Vec3& p) const { return p - 2 * (normal.dot(p) - offset) * normal; }
};

/// The plane about which some faces of a mesh are most nearly symmetric; none when the error of all
/// planes that were tried is above `tolerance`.
///
/// Directions all around and the principal axes are tried at the centroid, and the best few refined
/// by iterated closest points (point to plane, robustly weighted), so that equal principal moments
/// do no harm. Of several symmetry planes one is found. It may be missed if the centroid is far
/// from it. Deterministic; some ten thousand queries for the nearest face.
std::optional<Mirror> find_mirror(const Mesh& mesh, std::span<const int> faces,
                                  double tolerance = 0.02);

}  // namespace foldwright
