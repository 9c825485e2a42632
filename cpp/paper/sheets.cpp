#include "paper/sheets.h"

#include <algorithm>
#include <limits>

#include "mesh/input_error.h"
#include "paper/packing.h"
#include "paper/rows.h"

namespace foldwright {
namespace {

// The largest piece stays this share below the printable size, so that rounding cannot clip it.
constexpr double kFitSlack = 1 - 1e-9;

// Printers leave up to this much of the edge white, unless the margin says that this one does not.
constexpr double kUnprinted = 4;

// Rulers with their figures, and two lines of text.
constexpr double kRuledBand = 5.5;

/// The part of a sheet for pieces.
Extent room_on(const Extent& sheet, const SheetOptions& options) {
  const double taken = ruled_margin(options) + options.margin;
  return {sheet.width - taken, sheet.height - taken};
}

/// Among the turns that fit, the one with the smallest box; wider than high among near equals,
/// since rows waste less with low pieces.
Turn choose_turn(std::span<const Turn> turns, const Extent& room) {
  const Turn* best = nullptr;
  const auto cost = [](const Turn& t) {
    return t.box.width * t.box.height * (1 + 0.05 * t.box.height / (t.box.width + t.box.height));
  };
  for (const Turn& turn : turns) {
    if (!fits(turn, room)) continue;
    if (best == nullptr || cost(turn) < cost(*best)) best = &turn;
  }
  return *best;
}

/// Pieces in rows, by their boxes.
Packing pack_in_rows(std::span<const Footprint> pieces, const Extent& room, double gap) {
  Packing packing;
  std::vector<Extent> boxes;
  for (const Footprint& piece : pieces) {
    const std::vector<Vec2> hull = convex_hull(piece.points());
    const Turn turn = choose_turn(upright_turns(hull), room);
    boxes.push_back(turn.box);
    packing.turns.push_back(settle(hull, turn));
  }
  RowLayout rows = lay_in_rows(boxes, room, gap);
  packing.sheet_count = rows.sheet_count;
  packing.placements = std::move(rows.places);
  return packing;
}

SheetLayout make_layout(std::span<const Footprint> pieces, const Extent& sheet,
                        const SheetOptions& options) {
  const Extent room = room_on(sheet, options);
  Packing packing = pack(pieces, room, options.gap);
  // Rarely, boxes happen to fit better than what a greedy packing of shapes comes to.
  Packing rows = pack_in_rows(pieces, room, options.gap);
  if (rows.sheet_count < packing.sheet_count) packing = std::move(rows);
  SheetLayout layout;
  layout.turns = std::move(packing.turns);
  layout.placements = std::move(packing.placements);
  layout.sheet_width = sheet.width;
  layout.sheet_height = sheet.height;
  layout.sheet_count = packing.sheet_count;
  for (Placement& place : layout.placements) {
    place.x += ruled_margin(options);
    place.y += ruled_margin(options);
  }
  double area = 0;
  for (const Footprint& piece : pieces) area += piece.face_area;
  layout.efficiency = area / (sheet.width * sheet.height * layout.sheet_count);
  return layout;
}

}  // namespace

std::vector<Vec2> Footprint::points() const {
  std::vector<Vec2> all;
  for (const std::vector<Vec2>& polygon : polygons) {
    all.insert(all.end(), polygon.begin(), polygon.end());
  }
  return all;
}

double ruled_margin(const SheetOptions& options) {
  return std::max(options.margin, std::min(options.margin, kUnprinted) + kRuledBand);
}

Extent printable(const SheetOptions& options) {
  const Extent room = room_on({options.width, options.height}, options);
  if (room.width <= 0 || room.height <= 0) {
    throw InputError("bad-margin",
                     "margins leave nothing of the sheet: paper and margin do not fit");
  }
  return room;
}

double fitting_scale(std::span<const Footprint> pieces, const SheetOptions& options) {
  const Extent room = printable(options);
  double scale = std::numeric_limits<double>::infinity();
  for (const Footprint& piece : pieces) {
    double best = 0;
    for (const Turn& turn : upright_turns(convex_hull(piece.points()))) {
      best = std::max(best, std::min(room.width / turn.box.width, room.height / turn.box.height));
    }
    scale = std::min(scale, best);
  }
  return scale * kFitSlack;
}

SheetLayout lay_on_sheets(std::span<const Footprint> pieces, const SheetOptions& options) {
  printable(options);
  const Extent portrait = {options.width, options.height};
  const Extent landscape = {options.height, options.width};
  if (options.orientation == Orientation::kLandscape) {
    return make_layout(pieces, landscape, options);
  }
  SheetLayout layout = make_layout(pieces, portrait, options);
  if (options.orientation == Orientation::kPortrait) return layout;
  SheetLayout wide = make_layout(pieces, landscape, options);
  return wide.sheet_count < layout.sheet_count ? wide : layout;
}

}  // namespace foldwright
