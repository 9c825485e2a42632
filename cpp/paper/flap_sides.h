#pragma once

#include <array>
#include <span>
#include <vector>

#include "paper/seams.h"

namespace foldwright {

/// Heights of the flaps that a seam has room for at its two sides, mm; negative where none may be.
using SideHeights = std::array<double, 2>;

/// What it costs to change sides between two seams of a chain, in shares of a missing flap. Between
/// two pieces changes there and back cost less than a full flap that is lost, and more than a
/// little of one. A piece is glued to itself bit by bit: there it only decides between equals.
inline constexpr double kChangeBetween = 0.45;
inline constexpr double kChangeWithin = 0.01;

/// Per seam the side on which its flap goes: the higher one, but for chains, whose seams have
/// theirs on one bank as far as that loses less than changes cost. `heights`: per seam; `full`: of
/// a full flap, mm.
std::vector<int> sides_in_chains(std::span<const std::vector<SeamStep>> chains,
                                 std::span<const SideHeights> heights, double full, double change);

/// Per seam the side on which its flap goes where flaps alternate: along each outline on every
/// other edge.
std::vector<int> sides_in_turn(std::span<const Net> nets, std::span<const Seam> seams);

}  // namespace foldwright
