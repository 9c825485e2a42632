#include "geometry/box_pairs.h"

#include <algorithm>

namespace foldwright {
namespace {

/// Dense grid over the union of the boxes.
template <int N>
struct Grid {
  using Cell = std::array<int, N>;

  std::array<double, N> min;
  double per_cell;
  Cell size;

  Cell at(const std::array<double, N>& p) const {
    Cell cell;
    for (int i = 0; i < N; ++i) {
      cell[i] = std::clamp(static_cast<int>((p[i] - min[i]) * per_cell), 0, size[i] - 1);
    }
    return cell;
  }
  int index(const Cell& cell) const {
    int index = cell[N - 1];
    for (int i = N - 2; i >= 0; --i) index = index * size[i] + cell[i];
    return index;
  }
  int cell_count() const {
    int count = 1;
    for (const int n : size) count *= n;
    return count;
  }
  /// Calls `visit(index)` for every cell that the box covers.
  template <class Visit>
  void for_cells(const Box<N>& box, Visit&& visit) const {
    const Cell first = at(box.min);
    const Cell last = at(box.max);
    for (Cell cell = first; cell[N - 1] <= last[N - 1];) {
      visit(index(cell));
      int i = 0;
      while (i < N - 1 && cell[i] == last[i]) {
        cell[i] = first[i];
        ++i;
      }
      ++cell[i];
    }
  }
};

template <int N>
Grid<N> make_grid(std::span<const Box<N>> boxes) {
  Box<N> all = boxes[0];
  double sum = 0;
  for (const Box<N>& box : boxes) {
    for (int i = 0; i < N; ++i) {
      all.min[i] = std::min(all.min[i], box.min[i]);
      all.max[i] = std::max(all.max[i], box.max[i]);
      sum += box.max[i] - box.min[i];
    }
  }
  // Cells of the mean box size; larger when a sprawling layout would need more than 16 a box.
  const auto n = static_cast<double>(boxes.size());
  const auto cells = [&](double cell) {
    double count = 1;
    for (int i = 0; i < N; ++i) count *= (all.max[i] - all.min[i]) / cell + 1;
    return count;
  };
  double cell = std::max(sum / (N * n), 1e-300);
  while (cells(cell) > 16 * n + 16) cell *= 2;
  Grid<N> grid{all.min, 1 / cell, {}};
  for (int i = 0; i < N; ++i) {
    grid.size[i] = static_cast<int>((all.max[i] - all.min[i]) / cell) + 1;
  }
  return grid;
}

}  // namespace

template <int N>
std::vector<std::array<int, 2>> meeting_boxes(std::span<const Box<N>> boxes) {
  std::vector<std::array<int, 2>> pairs;
  if (boxes.empty()) return pairs;
  const Grid<N> grid = make_grid(boxes);
  const int n = static_cast<int>(boxes.size());

  // Counting sort of the boxes into the cells they cover.
  std::vector<int> first(static_cast<std::size_t>(grid.cell_count()) + 1, 0);
  for (const Box<N>& box : boxes) grid.for_cells(box, [&](int cell) { ++first[cell + 1]; });
  for (std::size_t cell = 1; cell < first.size(); ++cell) first[cell] += first[cell - 1];
  std::vector<int> members(first.back());
  std::vector<int> next(first.begin(), first.end() - 1);
  for (int i = 0; i < n; ++i) {
    grid.for_cells(boxes[i], [&](int cell) { members[next[cell]++] = i; });
  }

  for (int cell = 0; cell + 1 < static_cast<int>(first.size()); ++cell) {
    for (int p = first[cell]; p < first[cell + 1]; ++p) {
      const Box<N>& a = boxes[members[p]];
      for (int q = p + 1; q < first[cell + 1]; ++q) {
        const Box<N>& b = boxes[members[q]];
        if (!a.meets(b)) continue;
        // Boxes share several cells; the pair counts in that of their intersection's lower corner.
        std::array<double, N> corner;
        for (int i = 0; i < N; ++i) corner[i] = std::max(a.min[i], b.min[i]);
        if (grid.index(grid.at(corner)) == cell) pairs.push_back({members[p], members[q]});
      }
    }
  }
  return pairs;
}

template std::vector<std::array<int, 2>> meeting_boxes<2>(std::span<const Box2> boxes);
template std::vector<std::array<int, 2>> meeting_boxes<3>(std::span<const Box3> boxes);

}  // namespace foldwright
