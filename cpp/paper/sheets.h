#pragma once

#include <span>
#include <vector>

#include "unfold/net.h"

namespace foldwright {

enum class Orientation { kAuto, kPortrait, kLandscape };

/// Paper and how it is used; millimetres.
struct SheetOptions {
  double width = 210;  ///< portrait: width <= height. Default A4
  double height = 297;
  double margin = 10;  ///< kept free on all four sides; most printers need 4 to 6
  Orientation orientation = Orientation::kAuto;
  double gap = 4;  ///< between pieces: room for scissors
};

/// Where a piece lies: its sheet and its lower left corner there, in millimetres.
struct Placement {
  int sheet;
  double x, y;
};

/// Nets at their finished size, upright on sheets.
struct SheetLayout {
  double scale = 1;  ///< millimetres per model unit
  double sheet_width = 0, sheet_height = 0;
  int sheet_count = 0;
  double efficiency = 0;              ///< area of the faces over area of the sheets
  std::vector<Placement> placements;  ///< per net
};

/// Scales nets to millimetres and lays them out on sheets in simple rows, by bounding boxes.
///
/// The scale is the largest at which every net fits a sheet, so the largest one just fits and
/// nothing is clipped. Each net is turned so that its box is small and fits, and moved so that its
/// box starts at (0, 0). With automatic orientation the one that needs fewer sheets is taken, then
/// the larger scale, then portrait.
/// \throw InputError if the margins leave nothing of the sheet
SheetLayout lay_on_sheets(std::span<Net> nets, const SheetOptions& options = {});

}  // namespace foldwright
