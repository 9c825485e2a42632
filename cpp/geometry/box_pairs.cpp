#include "geometry/box_pairs.h"

#include <algorithm>
#include <cmath>

namespace foldwright {
namespace {

/// Dense grid over the union of the boxes.
struct Grid {
  double min_x, min_y, per_cell;
  int columns, rows;

  int column(double x) const {
    return std::clamp(static_cast<int>((x - min_x) * per_cell), 0, columns - 1);
  }
  int row(double y) const {
    return std::clamp(static_cast<int>((y - min_y) * per_cell), 0, rows - 1);
  }
};

Grid make_grid(std::span<const Box2> boxes) {
  Box2 all = boxes[0];
  double size = 0;
  for (const Box2& box : boxes) {
    all = {std::min(all.min_x, box.min_x), std::min(all.min_y, box.min_y),
           std::max(all.max_x, box.max_x), std::max(all.max_y, box.max_y)};
    size += (box.max_x - box.min_x) + (box.max_y - box.min_y);
  }
  const double width = all.max_x - all.min_x;
  const double height = all.max_y - all.min_y;
  const auto n = static_cast<double>(boxes.size());
  // Cells of the mean box size; larger when a sprawling layout would need more than 16 a box.
  const double mean = 0.5 * size / n;
  const double cell = std::max(
      {mean, std::sqrt(width * height / (16 * n)), std::max(width, height) / (16 * n), 1e-300});
  return {all.min_x, all.min_y, 1 / cell, static_cast<int>(width / cell) + 1,
          static_cast<int>(height / cell) + 1};
}

}  // namespace

std::vector<std::array<int, 2>> meeting_boxes(std::span<const Box2> boxes) {
  std::vector<std::array<int, 2>> pairs;
  if (boxes.empty()) return pairs;
  const Grid grid = make_grid(boxes);
  const int n = static_cast<int>(boxes.size());

  // Counting sort of the boxes into the cells they cover.
  std::vector<int> first(static_cast<std::size_t>(grid.columns) * grid.rows + 1, 0);
  const auto for_cells = [&](const Box2& box, auto&& visit) {
    const int last_column = grid.column(box.max_x);
    const int last_row = grid.row(box.max_y);
    for (int y = grid.row(box.min_y); y <= last_row; ++y) {
      for (int x = grid.column(box.min_x); x <= last_column; ++x) visit(y * grid.columns + x);
    }
  };
  for (const Box2& box : boxes) for_cells(box, [&](int cell) { ++first[cell + 1]; });
  for (std::size_t cell = 1; cell < first.size(); ++cell) first[cell] += first[cell - 1];
  std::vector<int> members(first.back());
  std::vector<int> next(first.begin(), first.end() - 1);
  for (int i = 0; i < n; ++i) for_cells(boxes[i], [&](int cell) { members[next[cell]++] = i; });

  for (int cell = 0; cell + 1 < static_cast<int>(first.size()); ++cell) {
    for (int p = first[cell]; p < first[cell + 1]; ++p) {
      const Box2& a = boxes[members[p]];
      for (int q = p + 1; q < first[cell + 1]; ++q) {
        const Box2& b = boxes[members[q]];
        if (!a.meets(b)) continue;
        // Boxes share several cells; the pair counts in that of their intersection's lower corner.
        const int x = grid.column(std::max(a.min_x, b.min_x));
        const int y = grid.row(std::max(a.min_y, b.min_y));
        if (y * grid.columns + x == cell) pairs.push_back({members[p], members[q]});
      }
    }
  }
  return pairs;
}

}  // namespace foldwright
