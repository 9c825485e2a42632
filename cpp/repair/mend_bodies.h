#pragma once

#include <vector>

#include "repair/crossing_bodies.h"
#include "repair/triangle_soup.h"

namespace foldwright {

/// What was found out about the bodies of a surface: its parts that edges connect.
struct BodyWork {
  Crossings crossings;  ///< among those that are left
  int inner = 0;        ///< bodies that lie in others; not looked for where crossings are not
};

/// Mends how bodies lie in each other.
///
/// A closed body in another one that the file winds against it is a cavity, and is wound inwards:
/// its paper shows its printed side to the hollow. Bodies in others, cavities among them, are left
/// out with `drop_inner`. `turned`: per face whether its winding is not that of the file; kept
/// right. \pre edges have at most two faces, and closed bodies are wound outwards
BodyWork mend_bodies(TriangleSoup& soup, bool drop_inner, std::vector<char>& turned);

}  // namespace foldwright
