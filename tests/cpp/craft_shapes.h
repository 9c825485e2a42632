#pragma once

#include <string>
#include <vector>

#include "solids.h"

namespace foldwright::testing {

/// A shape that people draw nets of by hand; in mm.
struct CraftShape {
  Solid solid;
  double by_hand;  ///< how much there is to glue in the best net that a person draws, mm
  int pieces;      ///< of that net, at most
};

/// Cube, cube of 4 x 4 grids, dodecahedron, prism of 6 sides, cylinder of 32, cone of 24, cup with
/// a handle, torus of 16 x 8, house, L, box with a hinged lid, open terrain of 5 x 5, icosphere,
/// and vase of 24 x 12.
///
/// By hand: the shortest set of edges that reaches every corner, and the border where there is one,
/// which is what any net in one piece cuts at least; for the torus and the vase bands around them.
std::vector<CraftShape> craft_shapes();

/// A cube from (0, 0, 0) whose sides are n x n squares.
Solid grid_cube_of(int n, double side);

/// As they are, each with its corners after those of the one before.
Solid together(std::string name, const std::vector<Solid>& solids);

/// The text of an OBJ file with the polygons of a solid.
std::string obj_of(const Solid& solid);

}  // namespace foldwright::testing
