#pragma once

#include <memory>
#include <optional>

#include "paper/sheets.h"

namespace foldwright {

/// Pieces on sheets of one size, by their true shapes.
struct Packing {
  int sheet_count = 0;
  int aslant = 0;                     ///< pieces with a grain that do not lie along it
  double used_height = 0;             ///< of the last sheet, mm from its top
  std::vector<Placement> placements;  ///< per piece, within the margins
  std::vector<RigidMotion2> turns;    ///< per piece: turns it and moves its box to (0, 0)
};

/// What is to be packed into rooms of one size.
struct PackingTask {
  std::span<const Footprint> pieces;
  Extent room;     ///< within the margins
  double gap = 3;  ///< between pieces, mm
  /// Per piece the part it belongs to, or empty.
  std::span<const int> parts = {};
  /// Per piece where it stays, from the room's lower left, or empty. \pre pins lie within the room
  /// and do not collide
  std::span<const std::optional<Pin>> pins = {};
  int effort = SheetTask::kFullEffort;  ///< orders that are tried, at most; 1: in fewer turns, too
};

/// Packs pieces into rooms: one after the other, each turned and put as far up on the first sheet
/// as it goes, on a raster of 1 mm that keeps the gap. Of many orders the best is taken, by the
/// number of sheets, the pieces that lie aslant to their grain, and the height used of the last
/// sheet, and among nearly equal ones that which tears fewer parts apart. Trying ends after an
/// amount of work that takes a quarter of a second.
class Packer {
 public:
  /// What the task refers to must outlive the packer. \pre each piece fits the room in some turn
  explicit Packer(const PackingTask& task);
  ~Packer();
  Packer(Packer&&) noexcept;

  /// Does some milliseconds of work; true when it is done.
  bool step();

  /// \pre `step` returned true; leaves the packer empty
  Packing take();

 private:
  class Work;
  std::unique_ptr<Work> work_;
};

}  // namespace foldwright
