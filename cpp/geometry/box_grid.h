#pragma once

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <vector>

#include "geometry/box.h"

namespace foldwright {

/// Hash grid over moving boxes: finds those that may meet a given one.
template <int N>
class BoxGrid {
 public:
  /// `cell`: edge length of a cell, about the size of a usual box.
  BoxGrid(int capacity, double cell)
      : per_cell_(1 / cell),
        mask_(std::bit_ceil(static_cast<std::size_t>(4 * capacity)) - 1),
        buckets_(mask_ + 1) {}

  void insert(int item, const Box<N>& box) {
    for_lists(box, [item](std::vector<int>& list) { list.push_back(item); });
  }

  void remove(int item, const Box<N>& box) {
    for_lists(box, [item](std::vector<int>& list) {
      const auto at = std::find(list.begin(), list.end(), item);
      assert(at != list.end());
      *at = list.back();
      list.pop_back();
    });
  }

  /// Calls `visit(item)` for every item that shares a cell with `box`, some several times, until
  /// it returns false.
  template <class Visit>
  void visit(const Box<N>& box, Visit&& visit) const {
    for (const int item : large_) {
      if (!visit(item)) return;
    }
    for_cells(cells_of(box), [&](const Cell& cell) {
      for (const int item : buckets_[bucket(cell)]) {
        if (!visit(item)) return false;
      }
      return true;
    });
  }

 private:
  using Cell = std::array<std::int64_t, N>;
  struct Range {
    Cell first, last;
  };

  // An item over more cells than this goes to the list that every query reads.
  static constexpr std::int64_t kMostCells = 64;

  Range cells_of(const Box<N>& box) const {
    Range range;
    for (int i = 0; i < N; ++i) {
      range.first[i] = static_cast<std::int64_t>(std::floor(box.min[i] * per_cell_));
      range.last[i] = static_cast<std::int64_t>(std::floor(box.max[i] * per_cell_));
    }
    return range;
  }

  static std::int64_t cell_count(const Range& range) {
    std::int64_t count = 1;
    for (int i = 0; i < N; ++i) count *= range.last[i] - range.first[i] + 1;
    return count;
  }

  /// Calls `visit(cell)` for each, until it returns false.
  template <class Visit>
  static void for_cells(const Range& range, Visit&& visit) {
    for (Cell cell = range.first;;) {
      if (!visit(cell)) return;
      int i = 0;
      while (i < N && cell[i] == range.last[i]) {
        cell[i] = range.first[i];
        ++i;
      }
      if (i == N) return;
      ++cell[i];
    }
  }

  /// Calls `change(list)` for every list that an item with this box is in.
  template <class Change>
  void for_lists(const Box<N>& box, Change&& change) {
    const Range range = cells_of(box);
    if (cell_count(range) > kMostCells) {
      change(large_);
      return;
    }
    for_cells(range, [&](const Cell& cell) {
      change(buckets_[bucket(cell)]);
      return true;
    });
  }

  std::size_t bucket(const Cell& cell) const {
    // Odd constants near 2^64 over powers of the golden ratio scatter neighbouring cells.
    constexpr std::uint64_t factors[] = {0x9e3779b97f4a7c15ull, 0xd1b54a32d192ed03ull,
                                         0x8ebc6af09c88c6e3ull};
    std::uint64_t mixed = 0;
    for (int i = 0; i < N; ++i) mixed += static_cast<std::uint64_t>(cell[i]) * factors[i];
    return static_cast<std::size_t>(mixed >> 32) & mask_;
  }

  double per_cell_;
  std::size_t mask_;
  std::vector<std::vector<int>> buckets_;
  std::vector<int> large_;  ///< items over so many cells that listing them in all would not pay
};

}  // namespace foldwright
