#include "paper/rows.h"

#include <algorithm>
#include <numeric>

namespace foldwright {
namespace {

struct Row {
  int sheet;
  double y, height, used;
};

}  // namespace

RowLayout lay_in_rows(std::span<const Extent> boxes, const Extent& room, double gap) {
  std::vector<int> by_height(boxes.size());
  std::iota(by_height.begin(), by_height.end(), 0);
  std::stable_sort(by_height.begin(), by_height.end(),
                   [&](int a, int b) { return boxes[a].height > boxes[b].height; });
  std::vector<Row> rows;
  std::vector<double> filled;  // height used, per sheet
  RowLayout layout;
  layout.places.resize(boxes.size());
  const auto open_row = [&](const Extent& box) -> Row& {
    int sheet = 0;
    const auto start = [&](int s) { return filled[s] > 0 ? filled[s] + gap : 0; };
    while (sheet < static_cast<int>(filled.size()) &&
           start(sheet) + box.height > room.height + kFitTolerance) {
      ++sheet;
    }
    if (sheet == static_cast<int>(filled.size())) filled.push_back(0);
    rows.push_back({sheet, start(sheet), box.height, 0});
    filled[sheet] = rows.back().y + box.height;
    return rows.back();
  };
  for (const int i : by_height) {
    const Extent& box = boxes[i];
    const auto start = [&](const Row& row) { return row.used > 0 ? row.used + gap : 0; };
    const auto has_room = [&](const Row& row) {
      return box.height <= row.height && start(row) + box.width <= room.width + kFitTolerance;
    };
    const auto found = std::find_if(rows.begin(), rows.end(), has_room);
    Row& row = found != rows.end() ? *found : open_row(box);
    // Sheets fill from the top, so that what is left over is one strip at the bottom.
    layout.places[i] = {row.sheet, start(row), room.height - row.y - box.height};
    row.used = start(row) + box.width;
  }
  layout.sheet_count = static_cast<int>(filled.size());
  return layout;
}

}  // namespace foldwright
