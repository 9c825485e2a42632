#pragma once

#include <vector>

#include "repair/triangle_soup.h"

namespace foldwright {

/// A closed loop of edges that have one face each. Edge i connects vertices i and i + 1, the last
/// one the last and the first vertex.
struct BorderLoop {
  std::vector<int> vertices;    ///< all different
  std::vector<int> half_edges;  ///< per edge: that of its face
};

/// The loops that the borders of a surface consist of, each edge in one of them at most. They run
/// against the faces beside them, or against most where these disagree.
///
/// Where loops touch in a vertex they are told apart there. Edges that are in no loop (of a fin on
/// a closed body) are left out. n log n.
std::vector<BorderLoop> find_border_loops(const TriangleSoup& soup);

}  // namespace foldwright
