#pragma once

#include "repair/mend_bodies.h"
#include "repair/solids.h"
#include "repair/triangle_soup.h"

namespace foldwright {

/// What became of bodies that run through each other.
struct UnitedBodies {
  int united = 0;  ///< bodies that became a share of another surface
  int open = 0;    ///< bodies that run through others and have no inside
  int failed = 0;  ///< bodies that have one, and could not be united all the same
};

/// Makes one surface of bodies that run through each other: what lies inside it is gone, and what
/// is left of a face keeps its place in the file.
///
/// Only closed bodies have an inside; a body takes its hollows along. All that cross each other,
/// one by one, are handed to `unite` together; where it fails, or where there is none, they stay as
/// they are. New vertices are as precise as the faces that meet there. The faces of other bodies
/// keep their order and come first. Winding and edges of what came out are to be looked at again.
/// \pre `work` is of this soup
UnitedBodies unite_bodies(TriangleSoup& soup, const BodyWork& work, const SolidUniter& unite);

}  // namespace foldwright
