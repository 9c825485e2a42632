#include "paper/sheets.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "geometry/convex2.h"
#include "mesh/input_error.h"
#include "paper/packing.h"
#include "paper/rows.h"

namespace foldwright {
namespace {

// The largest piece stays this share below the printable size, so that rounding cannot clip it.
constexpr double kFitSlack = 1 - 1e-9;

// What a person drags comes back through decimals; a hundredth of a millimetre is no overlap.
constexpr double kPinSlack = 0.01;

/// A piece where it lies, with boxes that tell most of it apart from others.
struct PlacedPrint {
  explicit PlacedPrint(Footprint placed) : print(std::move(placed)), box(box_of(print.points())) {
    for (const std::vector<Vec2>& polygon : print.polygons) boxes.push_back(box_of(polygon));
  }

  Footprint print;
  std::vector<Box2> boxes;  ///< per polygon
  Box2 box;
};

/// Whether two pieces where they lie overlap.
bool collide(const PlacedPrint& a, const PlacedPrint& b) {
  if (!a.box.meets(b.box)) return false;
  for (std::size_t i = 0; i < a.boxes.size(); ++i) {
    if (!a.boxes[i].meets(b.box)) continue;
    for (std::size_t j = 0; j < b.boxes.size(); ++j) {
      if (!a.boxes[i].meets(b.boxes[j])) continue;
      if (convex_overlap(a.print.polygons[i], b.print.polygons[j], kPinSlack)) return true;
    }
  }
  return false;
}

// Sine of the turn from which on a piece lies aslant: 0.1 mm over 10 cm.
constexpr double kAslant = 0.001;

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

/// A pinned piece where it lies, from the room's lower left.
Footprint placed(const Footprint& piece, const Pin& pin, const SheetOptions& options) {
  RigidMotion2 motion = settle_at(piece, pin.angle);
  const double corner = ruled_margin(options);
  motion.t += Vec2(pin.place.x - corner, pin.place.y - corner);
  Footprint print = piece;
  for (auto& polygon : print.polygons) {
    for (Vec2& p : polygon) p = motion(p);
  }
  return print;
}

bool is_within(const Footprint& print, const Extent& room) {
  return std::ranges::all_of(print.points(), [&](const Vec2& p) {
    return p.x() >= -kPinSlack && p.x() <= room.width + kPinSlack && p.y() >= -kPinSlack &&
           p.y() <= room.height + kPinSlack;
  });
}

/// The least move along an axis that takes what lies from `low` to `high` into a room from 0 to
/// `size`; 0 where that takes more than `play`, or is impossible.
double move_into(double low, double high, double size, double play) {
  const double move = std::max(0.0, -low) - std::max(0.0, high - size);
  const bool is_possible = high - low <= size + kPinSlack && std::abs(move) <= play;
  return is_possible ? move : 0;
}

/// The pin, moved so that its piece lies within the room where it sticks out by little.
Pin pulled_in(Pin pin, const Footprint& piece, const SheetTask& task, const Extent& room) {
  Vec2 low = Vec2::Constant(std::numeric_limits<double>::infinity());
  Vec2 high = -low;
  for (const Vec2& p : placed(piece, pin, task.options).points()) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  pin.place.x += move_into(low.x(), high.x(), room.width, task.pin_play);
  pin.place.y += move_into(low.y(), high.y(), room.height, task.pin_play);
  return pin;
}

std::vector<std::optional<Pin>> pulled_in(const SheetTask& task, const Extent& room) {
  std::vector<std::optional<Pin>> pins(task.pins.begin(), task.pins.end());
  for (std::size_t i = 0; i < pins.size(); ++i) {
    if (pins[i]) pins[i] = pulled_in(*pins[i], task.pieces[i], task, room);
  }
  return pins;
}

/// Pieces that lie on sheets already.
class PinnedPieces {
 public:
  void add(std::size_t piece, int sheet, PlacedPrint print) {
    placed_.push_back({piece, sheet, std::move(print)});
  }
  /// The first piece that one on a sheet would overlap.
  std::optional<std::size_t> hit_by(int sheet, const PlacedPrint& print) const {
    const auto found = std::ranges::find_if(placed_, [&](const Placed& other) {
      return other.sheet == sheet && collide(print, other.print);
    });
    return found == placed_.end() ? std::nullopt : std::optional(found->piece);
  }

 private:
  struct Placed {
    std::size_t piece;
    int sheet;
    PlacedPrint print;
  };
  std::vector<Placed> placed_;
};

/// Says why pins cannot stay; empty if they can.
std::optional<Parameters> fault_of_pins(const SheetTask& task,
                                        std::span<const std::optional<Pin>> pins,
                                        const Extent& room) {
  PinnedPieces pinned;
  for (std::size_t i = 0; i < pins.size(); ++i) {
    if (!pins[i]) continue;
    const int sheet = pins[i]->place.sheet;
    PlacedPrint print(placed(task.pieces[i], *pins[i], task.options));
    if (!is_within(print.print, room)) {
      return {{{"what", "outside"}, {"piece", task.names[i]}, {"sheet", sheet + 1}}};
    }
    if (const auto other = pinned.hit_by(sheet, print)) {
      return {{{"what", "overlap"},
               {"pieces", std::vector{task.names[*other], task.names[i]}},
               {"sheet", sheet + 1}}};
    }
    pinned.add(i, sheet, std::move(print));
  }
  return std::nullopt;
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

Pin pin_at(const Footprint& piece, int sheet, const RigidMotion2& motion) {
  const RigidMotion2 turn{motion.c, motion.s, Vec2::Zero()};
  double left = std::numeric_limits<double>::infinity();
  double low = left;
  for (const Vec2& point : piece.points()) {
    const Vec2 p = turn(point);
    left = std::min(left, p.x());
    low = std::min(low, p.y());
  }
  return {{sheet, left + motion.t.x(), low + motion.t.y()}, std::atan2(motion.s, motion.c)};
}

bool drop_clashing_pins(const SheetTask& task, std::span<const std::optional<Pin>> pins,
                        std::span<std::optional<Pin>> held) {
  const SheetOptions& options = task.options;
  const bool is_upright = options.orientation == Orientation::kPortrait;
  const Extent sheet =
      is_upright ? Extent{options.width, options.height} : Extent{options.height, options.width};
  const Extent room = room_on(sheet, options);
  PinnedPieces pinned;
  for (const bool by_person : {true, false}) {
    for (std::size_t i = 0; i < held.size(); ++i) {
      if (!held[i] || pins[i].has_value() != by_person) continue;
      if (by_person) held[i] = pulled_in(*held[i], task.pieces[i], task, room);
      const int on = held[i]->place.sheet;
      PlacedPrint print(placed(task.pieces[i], *held[i], options));
      if (is_within(print.print, room) && !pinned.hit_by(on, print)) {
        pinned.add(i, on, std::move(print));
      } else if (by_person) {
        return false;
      } else {
        held[i].reset();
      }
    }
  }
  return true;
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
