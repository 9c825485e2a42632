#include "paper/raster.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

namespace foldwright {
namespace {

// What reaches into a cell by less than this touches the line between two cells only.
constexpr double kRounding = 1e-6;

using Bits = std::vector<std::uint64_t>;

/// The extent along x of a convex polygon between two heights; empty where it has none.
std::optional<std::pair<double, double>> strip_extent(const std::vector<Vec2>& polygon, double low,
                                                      double high) {
  double from = std::numeric_limits<double>::infinity();
  double to = -from;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2& a = polygon[i];
    const Vec2& b = polygon[(i + 1) % polygon.size()];
    if (std::max(a.y(), b.y()) < low || std::min(a.y(), b.y()) > high) continue;
    for (const Vec2& p : {a, b}) {
      const double y = std::clamp(p.y(), low, high);
      const double share = b.y() == a.y() ? 0 : (y - a.y()) / (b.y() - a.y());
      const double x = b.y() == a.y() ? p.x() : a.x() + share * (b.x() - a.x());
      from = std::min(from, x);
      to = std::max(to, x);
    }
  }
  if (from > to) return std::nullopt;
  return std::pair(from, to);
}

/// Joins runs that touch or overlap.
void merge(std::vector<PieceRaster::Run>& runs) {
  std::ranges::sort(runs, {}, &PieceRaster::Run::from);
  std::vector<PieceRaster::Run> merged;
  for (const auto& [from, length] : runs) {
    if (!merged.empty() && from <= merged.back().from + merged.back().length) {
      int& last = merged.back().length;
      last = std::max(last, from + length - merged.back().from);
    } else {
      merged.push_back({from, length});
    }
  }
  runs = std::move(merged);
}

/// Moves all bits down by `by`.
void shift_down(const Bits& bits, int by, Bits& shifted) {
  const std::size_t words = static_cast<std::size_t>(by) / 64;
  const int rest = by % 64;
  for (std::size_t i = 0; i < bits.size(); ++i) {
    const std::uint64_t low = i + words < bits.size() ? bits[i + words] : 0;
    const std::uint64_t high = i + words + 1 < bits.size() ? bits[i + words + 1] : 0;
    shifted[i] = rest == 0 ? low : low >> rest | high << (64 - rest);
  }
}

/// Adds the places at which a run would touch a taken cell of the row.
void add_blocked(const Bits& row, const PieceRaster::Run& run, Bits& blocked, Bits& a, Bits& b) {
  shift_down(row, run.from, a);
  for (int covered = 1; covered < run.length;) {
    const int by = std::min(covered, run.length - covered);
    shift_down(a, by, b);
    for (std::size_t i = 0; i < a.size(); ++i) a[i] |= b[i];
    covered += by;
  }
  for (std::size_t i = 0; i < a.size(); ++i) blocked[i] |= a[i];
}

/// The first of the bits below `count` that is 0.
std::optional<int> first_zero(const Bits& bits, int count) {
  for (std::size_t i = 0; i < bits.size() && static_cast<int>(64 * i) < count; ++i) {
    if (~bits[i] == 0) continue;
    const int at = static_cast<int>(64 * i) + std::countr_one(bits[i]);
    if (at < count) return at;
    return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace

PieceRaster rasterize(const std::vector<std::vector<Vec2>>& polygons, const Extent& box) {
  PieceRaster raster{box, {}, {}};
  const int rows = std::max(1, static_cast<int>(std::ceil(box.height / kCell - kRounding)));
  raster.rows.resize(rows);
  for (const std::vector<Vec2>& polygon : polygons) {
    double low = box.height;
    double high = 0;
    for (const Vec2& p : polygon) {
      low = std::min(low, p.y());
      high = std::max(high, p.y());
    }
    const int first = std::clamp(static_cast<int>((box.height - high) / kCell), 0, rows - 1);
    const int last = std::clamp(static_cast<int>((box.height - low) / kCell), 0, rows - 1);
    for (int row = first; row <= last; ++row) {
      const double top = box.height - row * kCell;
      const auto extent = strip_extent(polygon, top - kCell, top);
      if (!extent) continue;
      const int from = std::max(0, static_cast<int>(extent->first / kCell));
      const int to = std::max(from, static_cast<int>((extent->second - kRounding) / kCell));
      raster.rows[row].push_back({from, to - from + 1});
    }
  }
  for (auto& runs : raster.rows) merge(runs);
  raster.widest_first.resize(rows);
  std::iota(raster.widest_first.begin(), raster.widest_first.end(), 0);
  std::ranges::stable_sort(raster.widest_first, std::greater{}, [&](int row) {
    int width = 0;
    for (const auto& run : raster.rows[row]) width += run.length;
    return width;
  });
  return raster;
}

SheetRaster::SheetRaster(const Extent& room)
    // One cell to spare, for pieces that are larger than the room by rounding.
    : room_(room), columns_(static_cast<int>(std::ceil(room.width / kCell)) + 1) {
  const auto rows = static_cast<std::size_t>(std::ceil(room.height / kCell)) + 1;
  rows_.assign(rows, Bits(static_cast<std::size_t>(columns_ + 63) / 64, 0));
  is_empty_.assign(rows, 1);
}

std::optional<CellPlace> SheetRaster::find(const PieceRaster& piece, int below,
                                           std::int64_t* work) const {
  if (!fits(piece.box, room_)) return std::nullopt;
  const double spare_width = room_.width - piece.box.width + kFitTolerance;
  const double spare_height = room_.height - piece.box.height + kFitTolerance;
  const int columns = static_cast<int>(spare_width / kCell) + 1;
  const int rows = static_cast<int>(spare_height / kCell) + 1;
  Bits blocked(rows_[0].size()), a(blocked.size()), b(blocked.size());
  std::int64_t looked_at = 0;
  std::optional<CellPlace> found;
  for (int y = 0; y < std::min(rows, below) && !found; ++y) {
    std::ranges::fill(blocked, 0);
    for (const int r : piece.widest_first) {
      const int row = y + r;
      if (is_empty_[row]) continue;
      for (const auto& run : piece.rows[r]) {
        add_blocked(rows_[row], run, blocked, a, b);
        // One pass to shift, one for each doubling of the run, one to join.
        looked_at += static_cast<std::int64_t>(a.size()) * (2 + std::bit_width(0u + run.length));
      }
      if (!first_zero(blocked, columns)) break;
    }
    if (const auto x = first_zero(blocked, columns)) found = CellPlace{*x, y};
  }
  if (work != nullptr) *work += looked_at;
  return found;
}

void SheetRaster::take(const PieceRaster& piece, const CellPlace& place, double gap) {
  const double cells = gap / kCell;
  const int reach = static_cast<int>(std::ceil(cells));
  for (std::size_t r = 0; r < piece.rows.size(); ++r) {
    for (int up = -reach; up <= reach; ++up) {
      const int row = place.y + static_cast<int>(r) + up;
      if (row < 0 || row >= row_count()) continue;
      // Points of cells n rows apart are at least n - 1 cells away from each other.
      const double apart = std::max(std::abs(up) - 1, 0);
      if (apart > 0 && apart >= cells) continue;
      const int wide = static_cast<int>(std::ceil(std::sqrt(cells * cells - apart * apart)));
      for (const auto& [from, length] : piece.rows[r]) {
        take_run(row, place.x + from - wide, place.x + from + length + wide);
      }
    }
  }
}

void SheetRaster::take_run(int row, int from, int to) {
  for (int x = std::max(from, 0); x < std::min(to, columns_); ++x) {
    rows_[row][x / 64] |= std::uint64_t{1} << (x % 64);
  }
  is_empty_[row] = 0;
}

}  // namespace foldwright
