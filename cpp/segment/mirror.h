#pragma once

#include <optional>
#include <vector>

#include "mesh/dual_graph.h"

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

/// The plane about which the faces of a graph are most nearly symmetric; none when the error of all
/// planes that were tried is above `tolerance`.
///
/// Directions all around and the principal axes are tried at the centroid, and the best few refined
/// by iterated closest points (point to plane, robustly weighted), so that equal principal moments
/// do no harm. Of several symmetry planes one is found. It may be missed if the centroid is far
/// from it. Deterministic; some ten thousand queries for the nearest face.
std::optional<Mirror> find_mirror(const Mesh& mesh, const DualGraph& graph,
                                  double tolerance = 0.02);

/// Per panel the one that lies where its mirror image is: of all panels nearest to the images of
/// its faces the one with most of their area. Not always an involution.
std::vector<int> mirrored_panels(const Mesh& mesh, const DualGraph& graph, const Mirror& mirror);

}  // namespace foldwright
