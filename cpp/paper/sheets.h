#pragma once

#include <span>
#include <vector>

#include "geometry/rigid_motion.h"
#include "paper/turns.h"

namespace foldwright {

enum class Orientation { kAuto, kPortrait, kLandscape };

/// Paper and how it is used; millimetres.
struct SheetOptions {
  double width = 210;  ///< portrait: width <= height. Default A4
  double height = 297;
  double margin = 10;  ///< kept free on all four sides; most printers need 4 to 6
  Orientation orientation = Orientation::kAuto;
  double gap = 3;  ///< between pieces: room for scissors
};

/// What of a piece takes up paper: convex polygons (faces and flaps), counter-clockwise,
/// anywhere in the plane.
struct Footprint {
  std::vector<std::vector<Vec2>> polygons;
  double face_area = 0;  ///< without flaps

  /// The corners of all polygons.
  std::vector<Vec2> points() const;
};

/// Where a piece lies: its sheet and the lower left corner of its box there, in millimetres.
struct Placement {
  int sheet;
  double x, y;
};

/// Pieces of their finished size on sheets.
struct SheetLayout {
  double scale = 1;  ///< millimetres per model unit; of the pieces that were laid out
  double sheet_width = 0, sheet_height = 0;
  int sheet_count = 0;
  double efficiency = 0;              ///< area of the faces over area of the sheets
  std::vector<Placement> placements;  ///< per piece
  /// Per piece: turns it as it lies, and moves its box to (0, 0).
  std::vector<RigidMotion2> turns;
};

/// What stays free at the left and the lower edge, in millimetres: the margin, or more where that
/// has no room for the rulers and the title that are printed there.
double ruled_margin(const SheetOptions& options);

/// The part of an upright sheet for pieces: within the margins, and beside rulers and title.
/// \throw InputError if the margins leave nothing of it
Extent printable(const SheetOptions& options);

/// The largest scale at which every piece fits a sheet in some turn.
/// \throw InputError if the margins leave nothing of the sheet
double fitting_scale(std::span<const Footprint> pieces, const SheetOptions& options);

/// Lays pieces of their finished size, in millimetres, out on sheets by their true shapes, on never
/// more sheets than rows of bounding boxes take. With automatic orientation the one that needs
/// fewer sheets is taken, then portrait. \pre each piece fits a sheet in some turn \throw
/// InputError if the margins leave nothing of the sheet
SheetLayout lay_on_sheets(std::span<const Footprint> pieces, const SheetOptions& options = {});

}  // namespace foldwright
