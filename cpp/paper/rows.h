#pragma once

#include <span>
#include <vector>

#include "paper/sheets.h"

namespace foldwright {

/// Where boxes lie on sheets.
struct RowLayout {
  int sheet_count = 0;
  std::vector<Placement> places;  ///< per box, from the lower left of the printable area
};

/// Lays boxes in rows from the top, high ones first; each box goes to the first row or sheet that
/// has room. \pre each box fits the room, all in millimetres
RowLayout lay_in_rows(std::span<const Extent> boxes, const Extent& room, double gap);

}  // namespace foldwright
