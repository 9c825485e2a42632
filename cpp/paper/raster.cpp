#include "paper/raster.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <span>

namespace foldwright {
namespace {

// What reaches into a cell by less than this touches the line between two cells only.
constexpr double kRounding = 1e-6;

/// A part of a row, in mm.
struct Span {
  double from = std::numeric_limits<double>::infinity();
  double to = -std::numeric_limits<double>::infinity();

  void add(double x) {
    from = std::min(from, x);
    to = std::max(to, x);
  }
};

/// Rows of cells from the top of a box downwards.
struct Rows {
  double height;
  int count;

  /// The row at some height, or the nearest one.
  int at(double y) const {
    return std::clamp(static_cast<int>((height - y) / kCell), 0, count - 1);
  }
};

/// Adds the extents along x that the edge from `a` to `b` has in rows; `spans`: of those from
/// `first` on.
void add_edge(const Vec2& a, const Vec2& b, const Rows& rows, int first, std::span<Span> spans) {
  const auto [bottom, top] = std::minmax(a.y(), b.y());
  const int last = first + static_cast<int>(spans.size()) - 1;
  // One row more on either side: an edge along the line between two is in both.
  const int lowest = std::min(rows.at(bottom) + 1, last);
  for (int row = std::max(rows.at(top) - 1, first); row <= lowest; ++row) {
    const double high = rows.height - row * kCell;
    const double low = high - kCell;
    if (top < low || bottom > high) continue;
    Span& span = spans[row - first];
    for (const Vec2& p : {a, b}) {
      if (top == bottom) {
        span.add(p.x());
        continue;
      }
      const double y = std::clamp(p.y(), low, high);
      span.add(a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
    }
  }
}

using Word = std::uint64_t;

/// Sets the bits from `from` to before `to`.
void set_bits(std::span<Word> bits, int from, int to) {
  for (int word = from / 64; 64 * word < to; ++word) {
    const int first = std::max(from - 64 * word, 0);
    const int last = std::min(to - 64 * word, 64) - 1;
    bits[word] |= ~Word{0} << first & ~Word{0} >> (63 - last);
  }
}

/// The first bit from `from` on that is 1, or 0 where `flip` has all bits; or else the number of
/// bits.
int next_bit(std::span<const Word> bits, int from, Word flip = 0) {
  const auto size = static_cast<int>(bits.size());
  for (int word = from / 64; word < size; ++word) {
    Word rest = bits[word] ^ flip;
    if (64 * word < from) rest &= ~Word{0} << from % 64;
    if (rest != 0) return 64 * word + std::countr_zero(rest);
  }
  return 64 * size;
}

std::vector<PieceRaster::Run> runs_of(std::span<const Word> bits) {
  std::vector<PieceRaster::Run> runs;
  const auto count = static_cast<int>(64 * bits.size());
  for (int from = next_bit(bits, 0); from < count;) {
    const int to = next_bit(bits, from, ~Word{0});
    runs.push_back({from, to - from});
    from = next_bit(bits, to);
  }
  return runs;
}

/// Adds bits, moved down by `by`, to the first words of others.
void add_moved_down(std::span<const Word> bits, int by, std::span<Word> sum) {
  const auto size = static_cast<int>(bits.size());
  const int words = by / 64;
  const int rest = by % 64;
  const int whole = std::min(static_cast<int>(sum.size()), size - words - 1);
  for (int i = 0; i < whole; ++i) {
    // In two steps, since a word cannot be moved by all of its bits.
    sum[i] |= bits[i + words] >> rest | bits[i + words + 1] << 1 << (63 - rest);
  }
  const int last = size - words - 1;
  if (last >= 0 && last < static_cast<int>(sum.size())) sum[last] |= bits[size - 1] >> rest;
}

/// The first of the bits below `count` that is 0.
std::optional<int> first_zero(std::span<const Word> bits, int count) {
  const int at = next_bit(bits, 0, ~Word{0});
  return at < count ? std::optional(at) : std::nullopt;
}

}  // namespace

PieceRaster rasterize(const std::vector<std::vector<Vec2>>& polygons, const Extent& box) {
  PieceRaster raster{box, {}, {}};
  const Rows rows = {box.height,
                     std::max(1, static_cast<int>(std::ceil(box.height / kCell - kRounding)))};
  int columns = 0;
  for (const std::vector<Vec2>& polygon : polygons) {
    for (const Vec2& p : polygon) columns = std::max(columns, static_cast<int>(p.x() / kCell) + 1);
  }
  // One more: rounding may take the end of an edge into the next one.
  const int words = columns / 64 + 1;
  std::vector<Word> bits(static_cast<std::size_t>(rows.count) * words, 0);
  const auto row_bits = [&](int row) {
    return std::span(&bits[static_cast<std::size_t>(row) * words], words);
  };
  std::vector<Span> spans;
  for (const std::vector<Vec2>& polygon : polygons) {
    double low = box.height;
    double high = 0;
    for (const Vec2& p : polygon) {
      low = std::min(low, p.y());
      high = std::max(high, p.y());
    }
    const int first = rows.at(high);
    spans.assign(rows.at(low) - first + 1, {});
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      add_edge(polygon[i], polygon[(i + 1) % polygon.size()], rows, first, spans);
    }
    for (int i = 0; i < static_cast<int>(spans.size()); ++i) {
      const auto& [left, right] = spans[i];
      if (left > right) continue;
      const int from = std::max(0, static_cast<int>(left / kCell));
      const int to = std::max(from, static_cast<int>((right - kRounding) / kCell));
      set_bits(row_bits(first + i), from, to + 1);
    }
  }
  std::vector<int> widths(rows.count, 0);
  for (int row = 0; row < rows.count; ++row) {
    raster.rows.push_back(runs_of(row_bits(row)));
    for (const PieceRaster::Run& run : raster.rows.back()) widths[row] += run.length;
  }
  raster.widest_first.resize(rows.count);
  std::iota(raster.widest_first.begin(), raster.widest_first.end(), 0);
  std::ranges::stable_sort(raster.widest_first, std::greater{},
                           [&](int row) { return widths[row]; });
  return raster;
}

SheetRaster::SheetRaster(const Extent& room)
    // One cell to spare, for pieces that are larger than the room by rounding.
    : room_(room), columns_(static_cast<int>(std::ceil(room.width / kCell)) + 1) {
  const auto rows = static_cast<std::size_t>(std::ceil(room.height / kCell)) + 1;
  rows_.assign(rows, Bits(static_cast<std::size_t>(columns_ + 63) / 64, 0));
  is_empty_.assign(rows, 1);
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
  set_bits(rows_[row], std::max(from, 0), std::min(to, columns_));
  is_empty_[row] = 0;
}

PlaceFinder::PlaceFinder(const SheetRaster& sheet)
    : sheet_(sheet),
      words_(static_cast<int>(sheet.rows_[0].size())),
      levels_(std::bit_width(static_cast<unsigned>(sheet.columns_))),
      touching_(start_of(sheet.row_count(), 0), 0) {
  for (int row = 0; row < sheet.row_count(); ++row) {
    if (sheet.is_empty_[row]) continue;
    std::ranges::copy(sheet.rows_[row], touching_.begin() + start_of(row, 0));
    for (int level = 1; level < levels_; ++level) {
      const std::span<Word> half(&touching_[start_of(row, level - 1)], words_);
      const std::span<Word> run(&touching_[start_of(row, level)], words_);
      std::ranges::copy(half, run.begin());
      add_moved_down(half, 1 << (level - 1), run);
    }
  }
}

std::size_t PlaceFinder::start_of(int row, int level) const {
  return (static_cast<std::size_t>(row) * levels_ + level) * words_;
}

/// Adds the places at which a run would touch a taken cell of the row.
void PlaceFinder::add_blocked(int row, const PieceRaster::Run& run,
                              std::vector<Word>& blocked) const {
  const int level = std::bit_width(static_cast<unsigned>(run.length)) - 1;
  const std::span<const Word> touching(&touching_[start_of(row, level)], words_);
  add_moved_down(touching, run.from, blocked);
  const int rest = run.length - (1 << level);
  if (rest > 0) add_moved_down(touching, run.from + rest, blocked);
}

std::optional<CellPlace> PlaceFinder::find(const PieceRaster& piece, int below,
                                           std::int64_t* work) const {
  const Extent& room = sheet_.room_;
  if (!fits(piece.box, room)) return std::nullopt;
  const double spare_width = room.width - piece.box.width + kFitTolerance;
  const double spare_height = room.height - piece.box.height + kFitTolerance;
  const int columns = static_cast<int>(spare_width / kCell) + 1;
  const int rows = static_cast<int>(spare_height / kCell) + 1;
  std::vector<Word> blocked(static_cast<std::size_t>(columns + 63) / 64);
  std::int64_t looked_at = 0;
  std::optional<CellPlace> found;
  for (int y = 0; y < std::min(rows, below) && !found; ++y) {
    std::ranges::fill(blocked, 0);
    for (const int r : piece.widest_first) {
      const int row = y + r;
      if (sheet_.is_empty_[row]) continue;
      for (const auto& run : piece.rows[r]) {
        add_blocked(row, run, blocked);
        // One pass to shift, one for each doubling of the run, one to join.
        looked_at += static_cast<std::int64_t>(words_) * (2 + std::bit_width(0u + run.length));
      }
      if (!first_zero(blocked, columns)) break;
    }
    if (const auto x = first_zero(blocked, columns)) found = CellPlace{*x, y};
  }
  if (work != nullptr) *work += looked_at;
  return found;
}

}  // namespace foldwright
