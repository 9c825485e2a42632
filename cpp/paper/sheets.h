#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
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
  double face_area = 0;              ///< without flaps
  std::optional<double> grain = {};  ///< see `grain_of`
  /// Cosine and sine of a turn in which it is known to fit the sheet. Flaps that were kept on the
  /// sheet in this turn change the hull, so that it may be none of the hull's upright turns.
  std::optional<std::array<double, 2>> fitting_turn = {};

  /// The corners of all polygons.
  std::vector<Vec2> points() const;
};

/// Where a piece lies: its sheet and the lower left corner of its box there, in millimetres.
struct Placement {
  int sheet;
  double x, y;
};

/// Where a person put a piece: the place of its turned box, and its turn from how it came, in
/// radians counter-clockwise.
struct Pin {
  Placement place;
  double angle;
};

/// Pieces of their finished size on sheets.
struct SheetLayout {
  double scale = 1;  ///< millimetres per model unit; of the pieces that were laid out
  double sheet_width = 0, sheet_height = 0;
  int sheet_count = 0;
  double used_height = 0;  ///< of the last sheet, from its upper margin to the lowest piece
  double efficiency = 0;   ///< area of the faces over area of the sheets
  std::vector<Placement> placements;  ///< per piece
  /// Per piece: turns it as it lies, and moves its box to (0, 0).
  std::vector<RigidMotion2> turns;
};

/// What is to be laid out.
struct SheetTask {
  std::span<const Footprint> pieces;
  SheetOptions options = {};
  std::span<const int> parts = {};                ///< per piece: its part; or empty
  std::span<const std::optional<Pin>> pins = {};  ///< per piece, or empty
  std::span<const std::string> names = {};        ///< per piece, for what is said of pins
  int effort = kFullEffort;                       ///< packings that are tried, at most
  /// Pinned pieces that stick out of the printable area by no more than this are moved into it, in
  /// millimetres: a pinned piece that gets a flap may have become larger.
  double pin_play = 0;

  static constexpr int kFullEffort = 200;
};

/// The turns worth trying for a piece with this convex hull: upright ones, and the one known to
/// fit.
std::vector<Turn> turns_of(const Footprint& piece, std::span<const Vec2> hull);

/// The turns in which a piece with this convex hull lies along its grain; empty without one.
std::vector<Turn> straight_turns(const Footprint& piece, std::span<const Vec2> hull);

/// Whether the piece fits the room along its grain, or somehow if it has none.
bool fits_straight(const Footprint& piece, const Extent& room);

/// Whether a piece that a motion turns lies aslant although it has a grain.
bool lies_aslant(const Footprint& piece, const RigidMotion2& motion);

/// Whether some of these turns of the piece fits the room.
bool fits_somehow(const Footprint& piece, const Extent& room);

/// Turns a piece by an angle, in radians counter-clockwise, and moves its box to (0, 0).
RigidMotion2 settle_at(const Footprint& piece, double angle);

/// What stays free at the left and the lower edge, in millimetres: the margin, or more where that
/// has no room for the rulers and the title that are printed there.
double ruled_margin(const SheetOptions& options);

/// The part of an upright sheet for pieces: within the margins, and beside rulers and title.
/// \throw InputError if the margins leave nothing of it
Extent printable(const SheetOptions& options);

/// The part of a sheet of this size for pieces.
Extent room_on(const Extent& sheet, const SheetOptions& options);

/// The largest scale at which every piece fits a sheet in some turn.
/// \throw InputError if the margins leave nothing of the sheet
double fitting_scale(std::span<const Footprint> pieces, const SheetOptions& options);

/// Lays pieces of their finished size, in millimetres, out on sheets by their true shapes, on never
/// more sheets than rows of bounding boxes take.
///
/// Pieces lie along their grain where that costs no sheet. With automatic orientation the one that
/// needs fewer sheets is taken, then where fewer lie aslant, then portrait; with pins the first on
/// which they lie. Pinned pieces stay where they are, and the others are packed around
/// them. \pre each piece fits a sheet in some turn
class SheetPlanner {
 public:
  /// What the task refers to must outlive the planner.
  /// \throw InputError if the margins leave nothing of the sheet, or a pinned piece leaves the
  /// printable area or lies on another one
  explicit SheetPlanner(const SheetTask& task);
  ~SheetPlanner();
  SheetPlanner(SheetPlanner&&) noexcept;
  SheetPlanner& operator=(SheetPlanner&&) noexcept;

  /// Does some milliseconds of work; true when it is done.
  bool step();

  /// \pre `step` returned true; leaves the planner empty
  SheetLayout take();

 private:
  class Work;
  std::unique_ptr<Work> work_;
};

/// All of it at once.
SheetLayout lay_on_sheets(const SheetTask& task);

}  // namespace foldwright
