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
        buckets_(mask_ + 1, kEnd) {
    entries_.reserve(8 * static_cast<std::size_t>(capacity));
  }

  void insert(int item, const Box<N>& box) {
    for_lists(box, [&](int& head) {
      if (free_ == kEnd) {
        free_ = static_cast<int>(entries_.size());
        entries_.push_back({item, kEnd});
      }
      const int entry = free_;
      free_ = entries_[entry].next;
      entries_[entry] = {item, head};
      head = entry;
    });
  }

  /// \pre it was inserted with this box
  void remove(int item, const Box<N>& box) {
    for_lists(box, [&](int& head) {
      int* link = &head;
      for (;; link = &entries_[*link].next) {
        assert(*link != kEnd);
        if (entries_[*link].item == item) break;
      }
      const int entry = *link;
      *link = entries_[entry].next;
      entries_[entry].next = free_;
      free_ = entry;
    });
  }

  /// Calls `visit(item)` for every item that shares a cell with `box`, some several times, until
  /// it returns false.
  template <class Visit>
  void visit(const Box<N>& box, Visit&& visit) const {
    const auto visit_list = [&](int entry) {
      for (; entry != kEnd; entry = entries_[entry].next) {
        if (!visit(entries_[entry].item)) return false;
      }
      return true;
    };
    if (!visit_list(large_)) return;
    for_cells(cells_of(box), [&](const Cell& cell) { return visit_list(buckets_[bucket(cell)]); });
  }

 private:
  using Cell = std::array<std::int64_t, N>;
  struct Range {
    Cell first, last;
  };

  /// An item of a list. The lists share one array, which keeps them close together in memory.
  struct Entry {
    int item, next;
  };
  static constexpr int kEnd = -1;

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

  /// Calls `change(head)` for every list that an item with this box is in.
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
  std::vector<int> buckets_;  ///< heads of lists
  std::vector<Entry> entries_;
  int free_ = kEnd;   ///< head of the list of entries that hold nothing
  int large_ = kEnd;  ///< items over so many cells that listing them in all would not pay
};

}  // namespace foldwright
