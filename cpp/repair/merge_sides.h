#pragma once

#include <vector>

#include "repair/triangle_soup.h"

namespace foldwright {

/// Which layers of faces that lie on each other are dropped.
struct LayerChoice {
  bool same = true;      ///< those with the same side up
  bool opposite = true;  ///< those with the other side up
};

/// Drops what repeats faces, however both are cut into triangles, and makes one skin of surfaces
/// that are given from both sides.
///
/// Faces side by side in one plane, up to `tolerance`, repeat others in that plane when both have
/// the same edges around them (`find_flat_layers`). They are given from both sides when their
/// winding is opposite. Connected faces of this kind are one skin, of which the later faces are
/// dropped, unless they are a wall between rooms: at each edge of their border at least two other
/// faces go on. Keeps the order of the faces. Returns the source faces of those that were dropped
/// for what lies on their other side, in no particular order.
/// n log n.
std::vector<int> merge_sides(TriangleSoup& soup, double tolerance, LayerChoice choice = {});

}  // namespace foldwright
