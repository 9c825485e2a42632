#pragma once

#include <optional>
#include <span>
#include <vector>

#include "paper/label.h"
#include "paper/seams.h"
#include "paper/sheets.h"

namespace foldwright {

/// A loose strip of paper that is glued behind both sides of a seam, as it lies before it is put on
/// a sheet: its fold runs from (0, 0) along x, and its upper half goes behind the first side.
struct StripShape {
  std::array<Vec2, 6> outline;  ///< counter-clockwise, from the start of the fold
  double length;                ///< of the fold, mm
  Label label;                  ///< the id of the seam
};

/// The strip for a seam: as long as its edge and 8 mm wide, or as wide as fits behind the faces.
/// None if the faces are too slim to hold glue, or the id does not fit on it.
/// `angle`: of its sides at the fold, at most; radians
std::optional<StripShape> make_strip(const Seam& seam, const std::string& id, double angle);

/// A strip on its sheet; all from the sheet's lower left.
struct Strip {
  int mesh_edge;
  std::string id;  ///< name of its seam, see `SeamId`
  int sheet;
  std::array<Vec2, 6> outline;
  Stroke fold;
  double angle;  ///< of the fold in radians: valley positive, mountain negative
  Label label;
};

/// What lies on the sheets before strips come.
struct StripTask {
  std::span<const Footprint> pieces;  ///< turned, their boxes from (0, 0)
  const SheetLayout* layout;
  SheetOptions options;
  bool may_add = false;  ///< whether sheets may be added
};

/// Puts strips where pieces leave room, long ones first; `strips` come without a place, and those
/// that find none are left out. Returned by edge; `sheet_count` of the task's layout does not grow
/// unless it may.
std::vector<Strip> place_strips(const StripTask& task, std::span<const StripShape> shapes,
                                std::vector<Strip> strips);

}  // namespace foldwright
