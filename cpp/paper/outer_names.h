#pragma once

#include <span>
#include <string>

#include "paper/labels.h"
#include "paper/sheet_obstacles.h"

namespace foldwright {

/// What lies on the sheets when names are written beside pieces.
struct OuterNameTask {
  SheetObstacles& sheets;              ///< gets the names as well
  std::span<const std::string> names;  ///< per piece
};

/// Writes the names of pieces that have no room for them beside these: within 8 mm, upright, on
/// nothing else, with a line that leads to the piece. They come first among the labels of their
/// piece, in its coordinates. Where a sheet is too full a piece stays without a name.
void write_outer_names(const OuterNameTask& task, LabelPlan& plan);

}  // namespace foldwright
