#pragma once

#include <span>
#include <vector>

#include "geometry/box.h"
#include "paper/sheets.h"
#include "paper/strips.h"
#include "paper/text_box.h"

namespace foldwright {

/// Something on a sheet that no text may lie on.
struct Obstacle {
  std::vector<Vec2> polygon;  ///< convex, counter-clockwise
  Box2 box;
  int piece;  ///< -1: of none
};

/// What lies around a piece on its sheet, in the piece's coordinates.
struct Surroundings {
  std::vector<Obstacle> obstacles;  ///< those of the piece itself included
  Box2 paper;                       ///< where texts may stand
};

/// What lies on sheets where texts are written beside pieces: faces, flaps, loose strips, and texts
/// as they come.
class SheetObstacles {
 public:
  /// `pieces`: turned, their boxes from (0, 0). All that is given must outlive this.
  SheetObstacles(std::span<const Footprint> pieces, const SheetLayout& layout,
                 const SheetOptions& options, std::span<const Strip> strips);

  /// What there is within `reach` of the box of a piece, mm.
  Surroundings around(int piece, double reach) const;

  /// Adds a text, in the coordinates of a piece, to the sheet of that.
  void take(int piece, const TextBox& text);

 private:
  void add(int sheet, std::vector<Vec2> polygon, int piece);

  std::span<const Footprint> pieces_;
  const SheetLayout& layout_;
  Box2 paper_;
  std::vector<std::vector<Obstacle>> on_;  ///< per sheet, from its lower left
};

}  // namespace foldwright
