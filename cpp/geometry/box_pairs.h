#pragma once

#include <array>
#include <span>
#include <vector>

#include "geometry/triangle2.h"

namespace foldwright {

/// All pairs (i, j), i < j, of boxes whose interiors meet, each once, in a fixed order.
///
/// A uniform grid with cells of about the mean box; near-linear for boxes of similar size, and
/// never worse than the number of cells the boxes cover, which is bounded by a constant times n
/// for boxes in a layout of n faces.
std::vector<std::array<int, 2>> meeting_boxes(std::span<const Box2> boxes);

}  // namespace foldwright
