#include "paper/packing.h"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "paper/raster.h"

namespace foldwright {
namespace {

// Turns that are tried of each piece: those with the smallest boxes and the same upside down, where
// it may nest, and others spread evenly.
constexpr std::size_t kTight = 4;
constexpr std::size_t kSpread = 12;

// So many would take minutes in all orders and turns. They are taken in one order, each in the
// smallest box and the same upside down.
constexpr std::size_t kManyPieces = 50;

// Sheets before the last so many count as full.
constexpr std::size_t kOpenSheets = 20;

/// A piece in one turn.
struct Candidate {
  RigidMotion2 motion;
  PieceRaster raster;
};

/// A piece in all its turns.
struct Item {
  std::vector<Candidate> candidates;
  double area = 0;   ///< of the cells touched
  double reach = 0;  ///< longer side of the smallest box
};

std::vector<Turn> chosen_turns(std::span<const Vec2> hull, const Extent& room) {
  std::vector<Turn> fitting;
  for (const Turn& turn : upright_turns(hull)) {
    if (fits(turn, room)) fitting.push_back(turn);
  }
  std::vector<Turn> by_area = fitting;
  std::ranges::stable_sort(by_area, {}, [](const Turn& t) { return t.box.width * t.box.height; });
  by_area.resize(std::min(kTight, by_area.size()));
  std::vector<Turn> chosen;
  for (const Turn& turn : by_area) {
    chosen.push_back(turn);
    chosen.push_back({-turn.c, -turn.s, turn.box});
  }
  const std::size_t spread = std::min(kSpread, fitting.size());
  for (std::size_t i = 0; i < spread; ++i) {
    const Turn& turn = fitting[i * fitting.size() / spread];
    const double side = i % 2 == 0 ? 1 : -1;
    chosen.push_back({side * turn.c, side * turn.s, turn.box});
  }
  return chosen;
}

Item make_item(const Footprint& piece, const Extent& room) {
  const std::vector<Vec2> hull = convex_hull(piece.points());
  Item item;
  for (const Turn& turn : chosen_turns(hull, room)) {
    const RigidMotion2 motion = settle(hull, turn);
    std::vector<std::vector<Vec2>> polygons = piece.polygons;
    for (auto& polygon : polygons) {
      for (Vec2& p : polygon) p = motion(p);
    }
    item.candidates.push_back({motion, rasterize(polygons, turn.box)});
  }
  const PieceRaster& first = item.candidates[0].raster;
  for (const auto& runs : first.rows) {
    for (const auto& run : runs) item.area += run.length;
  }
  item.reach = std::max(first.box.width, first.box.height);
  return item;
}

/// Where a piece goes on a sheet: the place at which it ends highest.
struct Spot {
  std::size_t candidate;
  CellPlace place;
  double bottom;
};

std::optional<Spot> best_spot(const SheetRaster& sheet, const Item& item, std::size_t turns) {
  std::optional<Spot> best;
  for (std::size_t i = 0; i < std::min(turns, item.candidates.size()); ++i) {
    const PieceRaster& raster = item.candidates[i].raster;
    // Lower places than this end below the best so far.
    const int below =
        best ? static_cast<int>((best->bottom - raster.box.height) / kCell) + 1 : sheet.row_count();
    const auto place = sheet.find(raster, below);
    if (!place) continue;
    const double bottom = place->y * kCell + raster.box.height;
    if (!best || bottom < best->bottom) best = Spot{i, *place, bottom};
  }
  return best;
}

/// How pieces are taken: their order, and how many of their turns are tried.
struct Strategy {
  std::vector<int> order;
  std::size_t turns;
};

Packing pack_by(std::span<const Item> items, const Strategy& strategy, const Extent& room,
                double gap) {
  Packing packing;
  packing.placements.resize(items.size());
  packing.turns.resize(items.size());
  std::vector<SheetRaster> sheets;
  std::vector<double> used;
  for (const int i : strategy.order) {
    for (std::size_t s = std::max(sheets.size(), kOpenSheets) - kOpenSheets;; ++s) {
      if (s == sheets.size()) {
        sheets.emplace_back(room);
        used.push_back(0);
      }
      const auto spot = best_spot(sheets[s], items[i], strategy.turns);
      if (!spot) continue;
      const Candidate& candidate = items[i].candidates[spot->candidate];
      sheets[s].take(candidate.raster, spot->place, gap);
      used[s] = std::max(used[s], spot->bottom);
      packing.turns[i] = candidate.motion;
      packing.placements[i] = {static_cast<int>(s), spot->place.x * kCell,
                               room.height - spot->bottom};
      break;
    }
  }
  packing.sheet_count = static_cast<int>(sheets.size());
  packing.used_height = used.empty() ? 0 : used.back();
  return packing;
}

}  // namespace

Packing pack(std::span<const Footprint> pieces, const Extent& room, double gap) {
  std::vector<Item> items;
  for (const Footprint& piece : pieces) items.push_back(make_item(piece, room));
  std::vector<int> order(items.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, std::greater{}, [&](int i) { return items[i].area; });
  std::vector<int> by_reach = order;
  std::ranges::stable_sort(by_reach, std::greater{}, [&](int i) { return items[i].reach; });
  // Turning a piece freely ends it higher, but may spoil the room beside it.
  const std::size_t all = 2 * kTight + kSpread;
  if (items.size() > kManyPieces) return pack_by(items, {by_reach, 2}, room, gap);
  const Strategy strategies[] = {
      {order, all}, {by_reach, all}, {order, 2 * kTight}, {by_reach, 2 * kTight}};
  const auto cost = [](const Packing& p) { return std::tuple(p.sheet_count, p.used_height); };
  std::optional<Packing> best;
  for (const Strategy& strategy : strategies) {
    Packing packing = pack_by(items, strategy, room, gap);
    if (!best || cost(packing) < cost(*best)) best = std::move(packing);
  }
  return std::move(*best);
}

}  // namespace foldwright
