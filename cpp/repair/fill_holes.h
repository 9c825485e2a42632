#pragma once

#include <vector>

#include "repair/triangle_soup.h"

namespace foldwright {

/// Holes of more edges are not filled.
inline constexpr int kMostHoleEdges = 5'000;

/// What became of the holes of a surface.
struct Holes {
  int filled = 0;
  int refused = 0;  ///< as narrow as asked for, but with no way to fill them
  int huge = 0;     ///< of too many edges, whatever their width
  /// Widths of the others that could be filled, ascending: the largest distance of two vertices.
  std::vector<double> left;
};

/// Fills the holes of a surface that are no wider than `widest` across, the narrow ones first.
///
/// A hole is a closed loop of edges with one face each. It is spanned by triangles between its own
/// vertices, of the least area (`span_loop`), that are wound as the faces beside them, have no
/// source, and at their corners the places in the file of these faces: so they look like what is
/// beside them. A hole is refused whose triangles would run through the surface or lie on it, as
/// those in the rim of a flat sheet would, would share an edge with two other faces, or would be
/// lower than `least_height`. One of more than `kMostHoleEdges` is left open: looking for its
/// triangles would take minutes.
/// n log n for holes of few edges, else see `span_loop`. \pre the surface is about 1 across
Holes fill_holes(TriangleSoup& soup, double widest, double least_height);

}  // namespace foldwright
