#pragma once

#include <vector>

#include "mesh/triangle_soup.h"

namespace foldwright {

/// Source faces of the triangles that `merge_sides` dropped, in no particular order.
struct MergedSides {
  std::vector<int> repeated;   ///< with the same side up as what they repeated
  std::vector<int> two_sided;  ///< with the other side up
};

/// Drops what repeats faces by another diagonal, and makes one skin of surfaces that are given from
/// both sides.
///
/// Two triangles side by side repeat two others when they are in one plane, up to `tolerance`, and
/// have the same four corners. A face is given from both sides when another one, or two that repeat
/// it by another diagonal, has the same corners in the opposite winding. Connected faces of this
/// kind are one skin, of which the later faces are dropped, unless they are a wall between rooms:
/// at each edge of their border at least two other faces go on. Keeps the order of the faces.
/// n log n. \pre no two faces have the same corners in the same winding
MergedSides merge_sides(TriangleSoup& soup, double tolerance);

}  // namespace foldwright
