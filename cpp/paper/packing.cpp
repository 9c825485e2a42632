#include "paper/packing.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "geometry/random.h"
#include "paper/raster.h"

namespace foldwright {
namespace {

// Turns that are tried of each piece: those with the smallest boxes and the same upside down, where
// it may nest, and others spread evenly.
constexpr std::size_t kTight = 4;
constexpr std::size_t kSpread = 12;
constexpr std::size_t kAllTurns = 2 * kTight + kSpread;

// So many would take minutes in all orders and turns. They are taken in one order, each in the
// smallest box and the same upside down.
constexpr std::size_t kManyPieces = 50;

// Sheets before the last so many count as full.
constexpr std::size_t kOpenSheets = 20;

// Words of rasters that are looked at before trying ends: a quarter of a second.
constexpr std::int64_t kMostWork = 50'000'000;

// And in a step: some milliseconds.
constexpr std::int64_t kWorkPerStep = 2'000'000;

// Changes of the best order in a row that may make nothing better.
constexpr std::size_t kPatience = 60;

// Last sheets whose used heights differ by less count as equal when parts would be torn apart.
constexpr double kEqualHeight = 10;

/// A piece in one turn.
struct Candidate {
  RigidMotion2 motion;
  PieceRaster raster;
};

/// A piece in all its turns.
struct Item {
  std::vector<Candidate> candidates;
  std::vector<Candidate> straight;  ///< along its grain; empty without one, or if none fits
  double area = 0;                  ///< of the cells touched
  double reach = 0;                 ///< longer side of the smallest box
};

std::vector<Turn> chosen_turns(std::span<const Turn> turns, const Extent& room) {
  std::vector<Turn> fitting;
  for (const Turn& turn : turns) {
    if (fits(turn.box, room)) fitting.push_back(turn);
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

std::vector<std::vector<Vec2>> moved(const Footprint& piece, const RigidMotion2& motion) {
  std::vector<std::vector<Vec2>> polygons = piece.polygons;
  for (auto& polygon : polygons) {
    for (Vec2& p : polygon) p = motion(p);
  }
  return polygons;
}

Candidate make_candidate(const Footprint& piece, std::span<const Vec2> hull, const Turn& turn) {
  const RigidMotion2 motion = turn_to_origin(hull, turn);
  return {motion, rasterize(moved(piece, motion), turn.box)};
}

Item make_item(const Footprint& piece, const Extent& room, std::size_t most_turns) {
  const std::vector<Vec2> hull = convex_hull(piece.points());
  std::vector<Turn> turns = chosen_turns(turns_of(piece, hull), room);
  // Packing it all the same would try sheet after sheet.
  if (turns.empty()) throw std::logic_error("a piece fits no sheet in any turn");
  turns.resize(std::min(turns.size(), most_turns));
  Item item;
  for (const Turn& turn : turns) {
    item.candidates.push_back(make_candidate(piece, hull, turn));
  }
  for (const Turn& turn : straight_turns(piece, hull)) {
    if (fits(turn.box, room)) item.straight.push_back(make_candidate(piece, hull, turn));
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
  const Candidate* candidate;
  CellPlace place;
  double bottom;
};

/// Adds the words of rasters that it looks at to `work`.
std::optional<Spot> best_spot(const SheetRaster& sheet, std::span<const Candidate> candidates,
                              std::int64_t& work) {
  const PlaceFinder finder(sheet);
  std::optional<Spot> best;
  for (const Candidate& candidate : candidates) {
    const PieceRaster& raster = candidate.raster;
    // Lower places than this end below the best so far.
    const int below =
        best ? static_cast<int>((best->bottom - raster.box.height) / kCell) + 1 : sheet.row_count();
    const auto place = finder.find(raster, below, &work);
    if (!place) continue;
    const double bottom = place->y * kCell + raster.box.height;
    if (!best || bottom < best->bottom) best = Spot{&candidate, *place, bottom};
  }
  return best;
}

/// How pieces are taken: their order, and how many of their turns are tried.
struct Strategy {
  std::vector<int> order;
  std::size_t turns;
  bool straight = false;  ///< whether pieces lie along their grain
  std::size_t same = 0;   ///< pieces at the beginning that lie as in the best packing
};

/// Sheets as they fill up. Copies share the sheets that are alike, so that it costs little to
/// remember the sheets before each piece.
class Sheets {
 public:
  std::size_t count() const { return sheets_.size(); }
  void add(const Extent& room) { sheets_.push_back({std::make_shared<SheetRaster>(room), 0}); }

  const SheetRaster& raster(std::size_t sheet) const { return *sheets_[sheet].raster; }
  /// Height used of the last sheet, from the top; 0 without sheets.
  double used_of_last() const { return sheets_.empty() ? 0 : sheets_.back().used; }

  /// Takes up cells of a sheet that reach down to `bottom`.
  void take(std::size_t sheet, const PieceRaster& piece, const CellPlace& place, double gap,
            double bottom) {
    Sheet& taken = sheets_[sheet];
    auto raster = std::make_shared<SheetRaster>(*taken.raster);
    raster->take(piece, place, gap);
    taken = {std::move(raster), std::max(taken.used, bottom)};
  }

 private:
  struct Sheet {
    std::shared_ptr<const SheetRaster> raster;
    double used;
  };
  std::vector<Sheet> sheets_;
};

}  // namespace

class Packer::Work {
 public:
  explicit Work(const PackingTask& task) : task_(task) {
    items_.reserve(task.pieces.size());
    pin_all();
  }

  bool step() {
    if (items_.size() < task_.pieces.size()) {
      if (is_pinned(static_cast<int>(items_.size()))) {
        items_.emplace_back();
        return false;
      }
      const std::size_t turns = task_.pieces.size() > kManyPieces || is_hurried() ? 2 : kAllTurns;
      items_.push_back(make_item(task_.pieces[items_.size()], task_.room, turns));
      return false;
    }
    if (strategies_.empty()) make_strategies();
    for (const std::int64_t end = work_ + kWorkPerStep; work_ < end;) {
      const Strategy& strategy = strategies_[current_];
      if (next_ < strategy.order.size() && !is_hopeless()) {
        history_.resize(next_);
        history_.push_back(sheets_);
        place(strategy.order[next_++], strategy);
        continue;
      }
      if (!is_hopeless()) finish();
      if (++current_ == strategies_.size()) perturb();
      if (current_ == strategies_.size()) return true;
      begin();
      ++work_;  // for orders of nothing
    }
    return false;
  }

  Packing take() { return std::move(*best_); }

 private:
  bool is_hurried() const { return task_.effort <= 1; }
  bool is_pinned(int piece) const { return !task_.pins.empty() && task_.pins[piece]; }

  void pin_all() {
    placed_.placements.resize(task_.pieces.size());
    placed_.turns.resize(task_.pieces.size());
    for (std::size_t i = 0; i < task_.pins.size(); ++i) {
      if (!task_.pins[i]) continue;
      const auto& [sheet, x, y] = task_.pins[i]->place;
      while (static_cast<int>(pinned_.count()) <= sheet) pinned_.add(task_.room);
      const RigidMotion2 turn = settle_at(task_.pieces[i], task_.pins[i]->angle);
      placed_.turns[i] = turn;
      placed_.placements[i] = task_.pins[i]->place;
      RigidMotion2 motion = turn;
      motion.t += Vec2(x, y);
      const PieceRaster raster = rasterize(moved(task_.pieces[i], motion), task_.room);
      double bottom = 0;
      for (std::size_t row = 0; row < raster.rows.size(); ++row) {
        if (!raster.rows[row].empty()) bottom = (row + 1) * kCell;
      }
      pinned_.take(sheet, raster, {0, 0}, task_.gap, bottom);
    }
    begin();
  }

  void make_strategies() {
    std::vector<int> order;
    for (int i = 0; i < static_cast<int>(items_.size()); ++i) {
      if (!is_pinned(i)) order.push_back(i);
    }
    std::ranges::stable_sort(order, std::greater{}, [&](int i) { return items_[i].area; });
    std::vector<int> by_reach = order;
    std::ranges::stable_sort(by_reach, std::greater{}, [&](int i) { return items_[i].reach; });
    // Turning a piece freely ends it higher, but may spoil the room beside it.
    if (items_.size() > kManyPieces || is_hurried()) {
      strategies_ = {{by_reach, 2}};
    } else {
      strategies_ = {
          {order, kAllTurns}, {by_reach, kAllTurns}, {order, 2 * kTight}, {by_reach, 2 * kTight}};
      if (!task_.parts.empty()) strategies_.push_back({by_part(order), kAllTurns});
    }
    if (std::ranges::all_of(items_, [](const Item& item) { return item.straight.empty(); })) return;
    std::vector<Strategy> along = strategies_;
    for (Strategy& strategy : along) strategy.straight = true;
    strategies_.insert(strategies_.begin(), along.begin(), along.end());
  }

  /// Parts one after the other, the largest first.
  std::vector<int> by_part(std::vector<int> order) const {
    std::vector<double> areas(*std::ranges::max_element(task_.parts) + 1, 0);
    for (const int i : order) areas[task_.parts[i]] += items_[i].area;
    std::ranges::stable_sort(order, std::greater{}, [&](int i) {
      return std::pair(areas[task_.parts[i]], task_.parts[i]);
    });
    return order;
  }

  /// Adds another order: the best so far with two pieces exchanged, or one moved.
  void perturb() {
    const bool is_single =
        items_.size() > kManyPieces || strategies_[best_strategy_].order.size() < 2;
    if (is_single || static_cast<int>(current_) >= task_.effort || work_ > kMostWork ||
        current_ > best_strategy_ + kPatience) {
      return;
    }
    Strategy next = strategies_[best_strategy_];
    const int count = static_cast<int>(next.order.size());
    const int from = random_.below(count);
    const int to = (from + 1 + random_.below(count - 1)) % count;
    next.same = static_cast<std::size_t>(std::min(from, to));
    if (random_.below(2) == 0) {
      std::swap(next.order[from], next.order[to]);
    } else {
      const int piece = next.order[from];
      next.order.erase(next.order.begin() + from);
      next.order.insert(next.order.begin() + to, piece);
    }
    strategies_.push_back(std::move(next));
  }

  void begin() {
    next_ = strategies_.empty() ? 0 : strategies_[current_].same;
    sheets_ = pinned_;
    history_.clear();
    aslant_ = 0;
    if (next_ == 0) return;
    sheets_ = best_history_[next_];
    history_.assign(best_history_.begin(),
                    best_history_.begin() + static_cast<std::ptrdiff_t>(next_));
    placed_ = *best_;
    for (std::size_t i = 0; i < next_; ++i) {
      const int piece = strategies_[current_].order[i];
      aslant_ += lies_aslant(task_.pieces[piece], placed_.turns[piece]);
    }
  }

  /// Whether what is placed already takes more paper than the best packing.
  bool is_hopeless() const {
    if (!best_) return false;
    const int count = static_cast<int>(sheets_.count());
    if (count != best_->sheet_count) return count > best_->sheet_count;
    if (aslant_ != best_->aslant) return aslant_ > best_->aslant;
    return sheets_.used_of_last() > std::ceil(best_->used_height / kEqualHeight) * kEqualHeight;
  }

  /// The turns in which a strategy tries a piece.
  std::span<const Candidate> turns_for(const Item& item, const Strategy& strategy) const {
    if (strategy.straight && !item.straight.empty()) return item.straight;
    return std::span(item.candidates).first(std::min(strategy.turns, item.candidates.size()));
  }

  void place(int i, const Strategy& strategy) {
    // Each piece fits an empty sheet, so that this ends there at the latest.
    for (std::size_t s = std::max(sheets_.count(), kOpenSheets) - kOpenSheets;; ++s) {
      if (s == sheets_.count()) sheets_.add(task_.room);
      const auto spot = best_spot(sheets_.raster(s), turns_for(items_[i], strategy), work_);
      if (!spot) continue;
      const Candidate& candidate = *spot->candidate;
      sheets_.take(s, candidate.raster, spot->place, task_.gap, spot->bottom);
      placed_.turns[i] = candidate.motion;
      aslant_ += lies_aslant(task_.pieces[i], candidate.motion);
      placed_.placements[i] = {static_cast<int>(s), spot->place.x * kCell,
                               task_.room.height - spot->bottom};
      return;
    }
  }

  /// Parts that lie on several sheets, each sheet beyond the first counted.
  int torn_parts(const Packing& packing) const {
    std::set<std::pair<int, int>> places;
    std::set<int> parts;
    for (std::size_t i = 0; i < task_.parts.size(); ++i) {
      places.emplace(task_.parts[i], packing.placements[i].sheet);
      parts.insert(task_.parts[i]);
    }
    return static_cast<int>(places.size() - parts.size());
  }

  void finish() {
    placed_.sheet_count = static_cast<int>(sheets_.count());
    placed_.aslant = aslant_;
    placed_.used_height = sheets_.used_of_last();
    const auto cost = [&](const Packing& p) {
      return std::tuple(p.sheet_count, p.aslant, std::ceil(p.used_height / kEqualHeight),
                        torn_parts(p), p.used_height);
    };
    if (best_ && !(cost(placed_) < cost(*best_))) return;
    best_ = placed_;
    best_strategy_ = current_;
    best_history_ = std::move(history_);
  }

  PackingTask task_;
  std::vector<Item> items_;
  Sheets pinned_, sheets_;
  std::vector<Strategy> strategies_;
  std::size_t current_ = 0;  ///< strategy
  std::size_t next_ = 0;     ///< of its order
  Packing placed_;
  int aslant_ = 0;  ///< of what is placed
  std::optional<Packing> best_;
  std::size_t best_strategy_ = 0;
  /// The sheets before each piece of an order is placed: of the one that goes on, and of the best.
  std::vector<Sheets> history_, best_history_;
  // Any seed would do: it is part of the method, so that equal pieces are packed equally.
  Random random_{1};
  std::int64_t work_ = 0;
};

Packer::Packer(const PackingTask& task) : work_(std::make_unique<Work>(task)) {}
Packer::~Packer() = default;
Packer::Packer(Packer&&) noexcept = default;
bool Packer::step() { return work_->step(); }
Packing Packer::take() { return work_->take(); }

}  // namespace foldwright
