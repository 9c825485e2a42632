#include "paper/sheets.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "geometry/convex2.h"
#include "mesh/input_error.h"
#include "paper/packing.h"
#include "paper/pins.h"
#include "paper/rows.h"

namespace foldwright {
namespace {

// The largest piece stays this share below the printable size, so that rounding cannot clip it.
constexpr double kFitSlack = 1 - 1e-9;

// Sine of the turn from which on a piece lies aslant: 0.1 mm over 10 cm.
constexpr double kAslant = 0.001;

// Printers leave up to this much of the edge white, unless the margin says that this one does not.
constexpr double kUnprinted = 4;

// Rulers with their figures, and two lines of text.
constexpr double kRuledBand = 5.5;

/// Among the turns that fit, the one with the smallest box; wider than high among near equals,
/// since rows waste less with low pieces.
Turn choose_turn(std::span<const Turn> turns, const Extent& room) {
  const Turn* best = nullptr;
  const auto cost = [](const Turn& t) {
    return t.box.width * t.box.height * (1 + 0.05 * t.box.height / (t.box.width + t.box.height));
  };
  for (const Turn& turn : turns) {
    if (!fits(turn.box, room)) continue;
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
    const Turn turn = choose_turn(turns_of(piece, hull), room);
    boxes.push_back(turn.box);
    packing.turns.push_back(turn_to_origin(hull, turn));
  }
  RowLayout rows = lay_in_rows(boxes, room, gap);
  packing.sheet_count = rows.sheet_count;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (rows.places[i].sheet + 1 < rows.sheet_count) continue;
    packing.used_height = std::max(packing.used_height, room.height - rows.places[i].y);
  }
  packing.placements = std::move(rows.places);
  return packing;
}

}  // namespace

class SheetPlanner::Work {
 public:
  explicit Work(const SheetTask& task) : task_(task) {
    printable(task.options);
    const Extent portrait = {task.options.width, task.options.height};
    const Extent landscape = {task.options.height, task.options.width};
    if (task.options.orientation != Orientation::kLandscape) sheets_.push_back(portrait);
    if (task.options.orientation != Orientation::kPortrait) sheets_.push_back(landscape);
    check_pins();
    begin();
  }

  bool step() {
    if (!packer_->step()) return false;
    SheetLayout layout = make_layout(packer_->take());
    const std::pair cost(layout.sheet_count, aslant_in(layout));
    if (!best_ || cost < best_cost_) {
      best_ = std::move(layout);
      best_cost_ = cost;
    }
    if (++current_ == sheets_.size()) return true;
    begin();
    return false;
  }

  SheetLayout take() { return std::move(*best_); }

 private:
  Extent room() const { return room_on(sheets_[current_], task_.options); }

  /// Keeps the first sheet on which pins can stay, if there are any.
  void check_pins() {
    if (std::ranges::none_of(task_.pins, [](const auto& pin) { return pin.has_value(); })) return;
    std::optional<Parameters> fault;
    for (current_ = 0; current_ < sheets_.size(); ++current_) {
      std::vector<std::optional<Pin>> pins = pulled_in(task_, room());
      std::optional<Parameters> found = fault_of_pins(task_, pins, room());
      if (!found) {
        room_pins_ = std::move(pins);
        sheets_ = {sheets_[current_]};
        current_ = 0;
        has_pins_ = true;
        for (std::optional<Pin>& pin : room_pins_) {
          if (!pin) continue;
          pin->place.x -= ruled_margin(task_.options);
          pin->place.y -= ruled_margin(task_.options);
        }
        return;
      }
      if (!fault) fault = std::move(found);
    }
    throw InputError("bad-pin", *fault);
  }

  void begin() {
    PackingTask task = {task_.pieces, room(), task_.options.gap, task_.parts};
    if (has_pins_) task.pins = room_pins_;
    task.effort = task_.effort;
    packer_.emplace(task);
  }

  SheetLayout make_layout(Packing packing) const {
    if (!has_pins_) {
      // Rarely, boxes happen to fit better than what a greedy packing of shapes comes to.
      Packing rows = pack_in_rows(task_.pieces, room(), task_.options.gap);
      if (rows.sheet_count < packing.sheet_count) packing = std::move(rows);
    }
    const Extent& sheet = sheets_[current_];
    SheetLayout layout;
    layout.turns = std::move(packing.turns);
    layout.placements = std::move(packing.placements);
    layout.sheet_width = sheet.width;
    layout.sheet_height = sheet.height;
    layout.sheet_count = packing.sheet_count;
    layout.used_height = packing.used_height;
    for (Placement& place : layout.placements) {
      place.x += ruled_margin(task_.options);
      place.y += ruled_margin(task_.options);
    }
    double area = 0;
    for (const Footprint& piece : task_.pieces) area += piece.face_area;
    layout.efficiency = area / (sheet.width * sheet.height * layout.sheet_count);
    return layout;
  }

  /// How many pieces lie aslant.
  int aslant_in(const SheetLayout& layout) const {
    int count = 0;
    for (std::size_t i = 0; i < task_.pieces.size(); ++i) {
      count += lies_aslant(task_.pieces[i], layout.turns[i]);
    }
    return count;
  }

  SheetTask task_;
  std::vector<Extent> sheets_;  ///< that are tried
  std::size_t current_ = 0;
  bool has_pins_ = false;
  std::vector<std::optional<Pin>> room_pins_;  ///< from the room's lower left
  std::optional<Packer> packer_;
  std::optional<SheetLayout> best_;
  std::pair<int, int> best_cost_;  ///< sheets, and pieces that lie aslant
};

Extent room_on(const Extent& sheet, const SheetOptions& options) {
  const double taken = ruled_margin(options) + options.margin;
  return {sheet.width - taken, sheet.height - taken};
}

SheetPlanner::SheetPlanner(const SheetTask& task) : work_(std::make_unique<Work>(task)) {}
SheetPlanner::~SheetPlanner() = default;
SheetPlanner::SheetPlanner(SheetPlanner&&) noexcept = default;
SheetPlanner& SheetPlanner::operator=(SheetPlanner&&) noexcept = default;
bool SheetPlanner::step() { return work_->step(); }
SheetLayout SheetPlanner::take() { return work_->take(); }

SheetLayout lay_on_sheets(const SheetTask& task) {
  SheetPlanner planner(task);
  while (!planner.step()) {
  }
  return planner.take();
}

std::vector<Vec2> Footprint::points() const {
  std::vector<Vec2> all;
  for (const std::vector<Vec2>& polygon : polygons) {
    all.insert(all.end(), polygon.begin(), polygon.end());
  }
  return all;
}

std::vector<Turn> turns_of(const Footprint& piece, std::span<const Vec2> hull) {
  std::vector<Turn> turns = upright_turns(hull);
  if (piece.fitting_turn) {
    const auto& [c, s] = *piece.fitting_turn;
    turns.push_back(turned(hull, {c, s, {}}));
    turns.push_back(turned(hull, {s, -c, {}}));
  }
  return turns;
}

std::vector<Turn> straight_turns(const Footprint& piece, std::span<const Vec2> hull) {
  std::vector<Turn> turns;
  if (!piece.grain) return turns;
  const double c = std::cos(*piece.grain);
  const double s = std::sin(*piece.grain);
  for (const auto& [x, y] : {std::pair(c, -s), {s, c}, {-c, s}, {-s, -c}}) {
    turns.push_back(turned(hull, {x, y, {}}));
  }
  return turns;
}

bool fits_straight(const Footprint& piece, const Extent& room) {
  if (!piece.grain) return fits_somehow(piece, room);
  const std::vector<Turn> turns = straight_turns(piece, convex_hull(piece.points()));
  return std::ranges::any_of(turns, [&](const Turn& turn) { return fits(turn.box, room); });
}

bool lies_aslant(const Footprint& piece, const RigidMotion2& motion) {
  if (!piece.grain) return false;
  const double c = std::cos(*piece.grain);
  const double s = std::sin(*piece.grain);
  const Vec2 along(motion.c * c - motion.s * s, motion.s * c + motion.c * s);
  return std::min(std::abs(along.x()), std::abs(along.y())) > kAslant;
}

bool fits_somehow(const Footprint& piece, const Extent& room) {
  const std::vector<Turn> turns = turns_of(piece, convex_hull(piece.points()));
  return std::ranges::any_of(turns, [&](const Turn& turn) { return fits(turn.box, room); });
}

RigidMotion2 settle_at(const Footprint& piece, double angle) {
  return turn_to_origin(convex_hull(piece.points()), {std::cos(angle), std::sin(angle), {}});
}

double ruled_margin(const SheetOptions& options) {
  return std::max(options.margin, std::min(options.margin, kUnprinted) + kRuledBand);
}

Extent printable(const SheetOptions& options) {
  const Extent room = room_on({options.width, options.height}, options);
  if (room.width <= 0 || room.height <= 0) {
    throw InputError("bad-margin");
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

}  // namespace foldwright
