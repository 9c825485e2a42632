#pragma once

#include <vector>

#include "paper/flap_cover.h"
#include "unfold/net.h"

namespace foldwright::testing {

/// A net of a whole mesh without overlaps, `size` mm large where the mesh has an extent of 2.
Net net_of(const Mesh& mesh, double size);

/// The six sides of a cube of 40 mm, each a net.
std::vector<Net> squares_of(const Mesh& cube);

/// The cover that a triangle over a whole base with this apex is.
FlapCover triangle_cover(double length, const Vec2& apex);

}  // namespace foldwright::testing
