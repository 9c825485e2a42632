#pragma once

#include <vector>

#include "repair/crossing_bodies.h"
#include "repair/triangle_soup.h"

namespace foldwright {

/// What was found out about the bodies of a surface: its parts that edges connect.
struct BodyWork {
  Crossings crossings;
  std::vector<int> bodies;  ///< per face: its body, from 0
  // Of a body, and empty where crossings were not looked for:
  std::vector<int> outermost;  ///< the outermost body that it lies in, -1 for none
  std::vector<int> cavity_of;  ///< the body whose cavity it is, -1 for none
  std::vector<char> closed;    ///< whether every edge of it has two faces

  int inner() const;     ///< number of bodies that lie in others
  int unitable() const;  ///< number of crossing pairs of closed bodies
};

/// Finds out how bodies lie, and winds cavities.
///
/// A closed body in another one that the file winds against it is a cavity, and is wound inwards:
/// its paper shows its printed side to the hollow. `turned`: per face whether its winding is not
/// that of the file; kept right. \pre edges have at most two faces, and closed bodies are wound
/// outwards
BodyWork mend_bodies(TriangleSoup& soup, std::vector<char>& turned);

/// Leaves out the bodies that lie in others, cavities among them, and what was found out about
/// them. \pre `work` and `turned` are of this soup
void drop_inner_bodies(TriangleSoup& soup, BodyWork& work, std::vector<char>& turned);

}  // namespace foldwright
