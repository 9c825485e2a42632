#pragma once

#include <vector>

#include "repair/split_nonmanifold.h"
#include "repair/triangle_soup.h"

namespace foldwright {

/// What it took to make a surface an oriented manifold.
struct ManifoldWork {
  std::vector<char> turned;  ///< per face: whether its winding is not that of the file
  int nonmanifold_edges = 0;
  int contradictions = 0;
  Splits splits;
};

/// Winds the faces and takes edges and vertices apart until the surface is an oriented manifold.
ManifoldWork make_manifold(TriangleSoup& triangles);

/// Winds the faces of an oriented manifold as the file does. Those that then disagree with the
/// ones beside them come apart from them, so that it stays an oriented manifold. `turned` is per
/// face.
Splits restore_winding(TriangleSoup& triangles, const std::vector<char>& turned);

}  // namespace foldwright
