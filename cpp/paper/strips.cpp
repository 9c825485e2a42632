#include "paper/strips.h"

#include <algorithm>
#include <numbers>

#include "paper/flap_room.h"
#include "paper/raster.h"

namespace foldwright {
namespace {

constexpr double kHalfWidth = 4;  // mm; a strip holds as a flap of 4 mm does
constexpr double kLeastHalf = 1.5;

// Between strips, which are cut one by one.
constexpr double kStripGap = 1;

constexpr double kTextSizes[] = {2.5, 2, 1.7, 1.4};
constexpr double kTextClearance = 0.3;

/// The half of a strip that goes behind the panel of a side, over (0, 0) to (length, 0).
std::optional<Trapezoid> half_behind(const SeamSide& side, double angle) {
  RoomProfile room = open_room(side.length(), kHalfWidth);
  lower_below(room, side.panel);
  return best_flap(room, side.panel.lean,
                   {.height = kHalfWidth, .least = kLeastHalf, .angles = {angle, angle}});
}

/// Whether a box lies within a trapezoid over y = 0, clear of its sides.
bool holds(const Trapezoid& half, const TextBox& box) {
  const auto corners = box.corners();
  const auto outline = half.corners();
  return std::ranges::all_of(corners, [&](const Vec2& p) {
    for (int i = 0; i < 4; ++i) {
      if (cross(outline[(i + 1) % 4] - outline[i], p - outline[i]) < 0) return false;
    }
    return true;
  });
}

/// The id on a half, as large as it goes.
std::optional<Label> label_on(const Trapezoid& half, const std::string& text) {
  for (const double size : kTextSizes) {
    const double y = 0.5 * kCapHeight * size + kTextClearance;
    const Vec2 centre(0.5 * (half.top[0] + half.top[1]), y);
    if (holds(half, box_around(text, {size, kTextClearance - 1e-9}, centre, Vec2(1, 0)))) {
      return Label{text, centre, 0, size};
    }
  }
  return std::nullopt;
}

/// A strip turned by nothing or a quarter.
struct Laid {
  RigidMotion2 motion;  ///< its box from (0, 0)
  PieceRaster raster;
};

Laid lay(const StripShape& shape, bool upright) {
  const std::vector<Vec2> outline(shape.outline.begin(), shape.outline.end());
  const double c = upright ? 0 : 1;
  const double s = upright ? 1 : 0;
  const RigidMotion2 motion = turn_to_origin(outline, {c, s, {}});
  std::vector<Vec2> turned;
  Extent box;
  for (const Vec2& p : outline) {
    turned.push_back(motion(p));
    box.width = std::max(box.width, turned.back().x());
    box.height = std::max(box.height, turned.back().y());
  }
  return {motion, rasterize({turned}, box)};
}

/// The sheets of a layout with the cells that are taken.
std::vector<SheetRaster> rasters_of(const StripTask& task, const Extent& room) {
  std::vector<SheetRaster> sheets(task.layout->sheet_count, SheetRaster(room));
  for (std::size_t i = 0; i < task.pieces.size(); ++i) {
    const auto& [sheet, x, y] = task.layout->placements[i];
    std::vector<std::vector<Vec2>> polygons = task.pieces[i].polygons;
    for (auto& polygon : polygons) {
      for (Vec2& p : polygon) p += Vec2(x, y) - Vec2::Constant(ruled_margin(task.options));
    }
    sheets[sheet].take(rasterize(polygons, room), {0, 0}, task.options.gap);
  }
  return sheets;
}

/// Moves a strip and what is on it.
Strip placed(Strip strip, const StripShape& shape, const RigidMotion2& motion, bool upright) {
  for (std::size_t i = 0; i < shape.outline.size(); ++i)
    strip.outline[i] = motion(shape.outline[i]);
  strip.fold = {motion(Vec2(0, 0)), motion(Vec2(shape.length, 0))};
  strip.label = shape.label;
  strip.label.centre = motion(shape.label.centre);
  strip.label.angle = upright ? 0.5 * std::numbers::pi : 0;
  return strip;
}

}  // namespace

std::optional<StripShape> make_strip(const Seam& seam, const std::string& id, double angle) {
  const auto upper = half_behind(seam.sides[0], angle);
  const auto lower = half_behind(seam.sides[1], angle);
  if (!upper || !lower) return std::nullopt;
  const double length = seam.sides[0].length();
  // The lower half is the other side's, turned by half a turn about the middle of the fold.
  const auto below = [&](double x) { return Vec2(length - x, -lower->height); };
  StripShape shape;
  shape.length = length;
  shape.outline = {Vec2(0, 0),
                   below(lower->top[1]),
                   below(lower->top[0]),
                   Vec2(length, 0),
                   Vec2(upper->top[1], upper->height),
                   Vec2(upper->top[0], upper->height)};
  auto label = label_on(*upper, id);
  if (!label) {
    Trapezoid turned = *lower;
    label = label_on(turned, id);
    if (!label) return std::nullopt;
    // It would stand on its head there; moved below the fold, it stands upright.
    label->centre = {length - label->centre.x(), -label->centre.y()};
  }
  shape.label = *label;
  return shape;
}

std::vector<Strip> place_strips(const StripTask& task, std::span<const StripShape> shapes,
                                std::vector<Strip> strips) {
  const Vec2 corner = Vec2::Constant(ruled_margin(task.options));
  const double taken = corner.x() + task.options.margin;
  const Extent room = {task.layout->sheet_width - taken, task.layout->sheet_height - taken};
  std::vector<SheetRaster> sheets = rasters_of(task, room);
  std::vector<int> order(shapes.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
  std::ranges::stable_sort(order, std::greater{}, [&](int i) { return shapes[i].length; });
  std::vector<Strip> found;
  for (const int i : order) {
    const std::array<Laid, 2> ways = {lay(shapes[i], false), lay(shapes[i], true)};
    for (std::size_t s = 0; s <= sheets.size(); ++s) {
      const bool is_new = s == sheets.size();
      if (is_new && !task.may_add) break;
      if (is_new) sheets.emplace_back(room);
      int chosen = -1;
      CellPlace best{0, 0};
      const PlaceFinder finder(sheets[s]);
      for (const int way : {0, 1}) {
        const auto place = finder.find(ways[way].raster, sheets[s].row_count());
        if (!place) continue;
        const auto bottom = [&](int w, const CellPlace& at) {
          return at.y * kCell + ways[w].raster.box.height;
        };
        if (chosen != -1 && bottom(chosen, best) <= bottom(way, *place)) continue;
        chosen = way;
        best = *place;
      }
      if (chosen == -1) {
        if (!is_new) continue;
        sheets.pop_back();  // too long for any sheet
        break;
      }
      const PieceRaster& raster = ways[chosen].raster;
      sheets[s].take(raster, best, kStripGap);
      RigidMotion2 motion = ways[chosen].motion;
      motion.t += corner + Vec2(best.x * kCell, room.height - best.y * kCell - raster.box.height);
      strips[i].sheet = static_cast<int>(s);
      found.push_back(placed(strips[i], shapes[i], motion, chosen == 1));
      break;
    }
  }
  std::ranges::sort(found, {}, &Strip::mesh_edge);
  return found;
}

}  // namespace foldwright
