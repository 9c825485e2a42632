#pragma once

#include <span>
#include <vector>

#include "geometry/vec.h"

namespace foldwright {

/// For each position the index of the one that stands for it: itself, or the nearest earlier one
/// that stands for itself and lies within `tolerance`.
///
/// Positions that stand for themselves are further apart than `tolerance`, so long chains of near
/// points do not collapse into one. The result depends on the order of the positions only.
/// Coordinates must lie within +-1 or so: cells are numbered with 21 bits. Linear time, except
/// for many points packed within some ten tolerances.
std::vector<int> weld(std::span<const Vec3> positions, double tolerance);

}  // namespace foldwright
