#pragma once

#include "repair/drawn_planes.h"
#include "repair/triangle_soup.h"

namespace foldwright {

/// What `flatten_planes` did.
struct Flattening {
  std::vector<int> faces;  ///< of the planes that only it made flat enough for one panel, ascending
  double distance = 0;     ///< how far the vertex that moved furthest did
};

/// Moves vertices as little as it takes for the faces of each plane to lie in it to the last
/// digits.
///
/// All planes of a surface that share vertices are solved together, since a vertex mostly lies in
/// several: proximal Gauss-Newton over the vertices and the planes, a few sparse factorizations.
/// Surfaces whose planes are exact already are left as they are. Where vertices would have to move
/// by far more than the planes were off, or faces would turn over (planes that contradict each
/// other), those planes are given up and the others are solved again.
Flattening flatten_planes(TriangleSoup& soup, const DrawnPlanes& planes);

}  // namespace foldwright
