#pragma once

#include "repair/orient.h"
#include "repair/triangle_soup.h"

namespace foldwright {

/// What `split_nonmanifold` had to do.
struct Splits {
  int vertices = 0;   ///< vertices that were given to several fans of faces, one copy each
  int midpoints = 0;  ///< edges that were halved
};

/// Makes the vertices say what the partners say: afterwards two faces are joined by an edge exactly
/// when they were partners, and the faces at a vertex are one fan.
///
/// Each fan gets its own copy of the vertex. Where two edges of a surface still connect the same
/// two vertices (a sheet with two sides has them at its corners), all but one are halved.
/// \pre partners run along their edge in opposite directions
Splits split_nonmanifold(TriangleSoup& soup, const Partners& partners);

}  // namespace foldwright
