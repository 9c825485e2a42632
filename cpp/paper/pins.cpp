#include "paper/pins.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "geometry/convex2.h"

namespace foldwright {
namespace {

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

}  // namespace

std::vector<std::optional<Pin>> pulled_in(const SheetTask& task, const Extent& room) {
  std::vector<std::optional<Pin>> pins(task.pins.begin(), task.pins.end());
  for (std::size_t i = 0; i < pins.size(); ++i) {
    if (pins[i]) pins[i] = pulled_in(*pins[i], task.pieces[i], task, room);
  }
  return pins;
}

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

}  // namespace foldwright
