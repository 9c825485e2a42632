#pragma once

#include <array>
#include <span>
#include <vector>

#include "paper/turns.h"

namespace foldwright {

/// A net as rigid plates and the folds between them, which form a tree.
struct Plates {
  std::vector<std::vector<Vec2>> corners;  ///< per plate, as the net lies flat; mm
  std::vector<double> areas;               ///< per plate
  std::vector<std::array<int, 2>> folds;   ///< plates that each fold joins
};

/// The fold to cut a net at that is too large for `room`, as an index into `folds`.
///
/// Chosen is the cut after which the fewest pieces come out, as far as a search of a few cuts ahead
/// can tell; of equals the one whose halves are nearest in area and most compact, then the first.
/// Nets of many plates are looked at one cut ahead only. Takes time quadratic in the plates.
/// \pre there is a fold
int choose_cut(const Plates& plates, const Extent& room);

}  // namespace foldwright
