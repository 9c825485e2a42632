#pragma once

#include <array>
#include <span>
#include <vector>

#include "paper/seams.h"

namespace foldwright {

/// Heights of the flaps that a seam has room for at its two sides, mm; negative where none may be.
using SideHeights = std::array<double, 2>;

/// Per seam the side on which its flap goes: the higher one, but for chains, whose seams have
/// theirs on one bank as far as that loses little. `heights`: per seam; `full`: of a full flap, mm.
std::vector<int> sides_in_chains(std::span<const std::vector<SeamStep>> chains,
                                 std::span<const SideHeights> heights, double full);

/// Per seam the side on which its flap goes where flaps alternate: along each outline on every
/// other edge.
std::vector<int> sides_in_turn(std::span<const Net> nets, std::span<const Seam> seams);

}  // namespace foldwright
