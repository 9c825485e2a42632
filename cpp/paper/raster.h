#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "paper/turns.h"

namespace foldwright {

/// Side of a cell in mm. A finer grid packs hardly closer and takes longer.
inline constexpr double kCell = 1;

/// A piece as cells: per row, from the top of its box downwards, the runs that it touches.
struct PieceRaster {
  struct Run {
    int from, length;
  };
  Extent box;  ///< mm
  std::vector<std::vector<Run>> rows;
  std::vector<int> widest_first;  ///< rows in the order in which they are likely to be in the way
};

/// The cells that convex polygons touch, whose box starts at (0, 0). Linear in the cells.
PieceRaster rasterize(const std::vector<std::vector<Vec2>>& polygons, const Extent& box);

/// A cell from the upper left.
struct CellPlace {
  int x, y;
};

/// A sheet on which pieces take up cells, and a gap around them.
class SheetRaster {
 public:
  /// `room`: within the margins, mm
  explicit SheetRaster(const Extent& room);

  /// Takes the piece's cells and all that may be nearer to it than `gap`.
  void take(const PieceRaster& piece, const CellPlace& place, double gap);

  int row_count() const { return static_cast<int>(rows_.size()); }

 private:
  friend class PlaceFinder;
  using Bits = std::vector<std::uint64_t>;

  void take_run(int row, int from, int to);

  Extent room_;
  int columns_;
  std::vector<Bits> rows_;
  std::vector<char> is_empty_;  ///< per row
};

/// Looks for places on a sheet, for one piece after the other. Where runs of a power of two would
/// touch what is taken is in tables, made once per sheet; two such runs cover one of any length.
class PlaceFinder {
 public:
  /// The sheet must outlive this, and nothing may be taken meanwhile.
  explicit PlaceFinder(const SheetRaster& sheet);

  /// The highest place, and of those the leftmost, where the piece touches no cell taken and stays
  /// within the sheet; none if there is none above row `below`. Adds what it does to `work`, if
  /// given, in words that would be looked at without tables: a measure that is the same everywhere.
  std::optional<CellPlace> find(const PieceRaster& piece, int below,
                                std::int64_t* work = nullptr) const;

 private:
  using Word = std::uint64_t;

  std::size_t start_of(int row, int level) const;
  void add_blocked(int row, const PieceRaster::Run& run, std::vector<Word>& blocked) const;

  const SheetRaster& sheet_;
  int words_, levels_;
  /// Per row and level: the first cells of runs of 2^level cells that touch a taken one.
  std::vector<Word> touching_;
};

}  // namespace foldwright
