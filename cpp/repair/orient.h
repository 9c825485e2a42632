#pragma once

#include <vector>

#include "repair/triangle_soup.h"

namespace foldwright {

/// Per half-edge the one it is joined to across its edge, or -1 at a border; always mutual.
using Partners = std::vector<int>;

/// How the faces have to be turned so that joined faces agree on what is outside.
struct Orientation {
  std::vector<int> patches;  ///< per face: its patch, connected through partners, from 0
  std::vector<char> turned;  ///< per face: whether its winding has to be reversed
  std::vector<char> solid;   ///< per patch: whether it encloses a volume by itself
  /// Half-edges, one per edge, whose two faces disagree however they are turned: all loops of a
  /// non-orientable patch that reverse the winding cross one of them.
  std::vector<int> contradictions;
};

/// Winds each patch consistently: outwards where it encloses a volume, else as most of its area is
/// wound in the file. `turned_before` tells which faces are not wound as in the file.
Orientation orient(const TriangleSoup& soup, const Partners& partners,
                   const std::vector<char>& turned_before);

/// Reverses the winding of faces.
void turn_faces(TriangleSoup& soup, const std::vector<char>& turned);

/// The same, and keeps the partners right.
void turn_faces(TriangleSoup& soup, Partners& partners, const std::vector<char>& turned);

}  // namespace foldwright
