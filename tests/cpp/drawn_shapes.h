#pragma once

#include "mesh/mesh.h"

/// Shapes whose nets people draw by hand. All are closed and wound outwards.
namespace foldwright::testing {

/// A cube of side 2 whose sides are `n` x `n` squares of two triangles each.
Mesh grid_cube(int n);

/// A prism over a regular polygon in the unit circle, with lids; its walls stand along y.
Mesh prism(int sides, double height);

/// Prism over an L: 8 panels, the caps hexagons, and a single valley in the inner corner.
Mesh l_prism();

}  // namespace foldwright::testing
