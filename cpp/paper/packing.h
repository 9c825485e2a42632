#pragma once

#include "paper/sheets.h"

namespace foldwright {

/// Pieces on sheets of one size, by their true shapes.
struct Packing {
  int sheet_count = 0;
  double used_height = 0;             ///< of the last sheet, mm from its top
  std::vector<Placement> placements;  ///< per piece, within the margins
  std::vector<RigidMotion2> turns;    ///< per piece: turns it and moves its box to (0, 0)
};

/// Packs pieces into rooms: large ones first, each turned and put as far up on the first sheet as
/// it goes, on a raster of 1 mm that keeps `gap` millimetres between pieces. Of a few orders the
/// best is taken. \pre each piece fits the room in some turn
Packing pack(std::span<const Footprint> pieces, const Extent& room, double gap);

}  // namespace foldwright
