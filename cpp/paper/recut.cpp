#include "paper/recut.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace foldwright {
namespace {

/// Per plate whether it lies on the side of `folds[cut][1]`.
std::vector<char> far_side(const Plates& plates, const std::vector<std::vector<int>>& neighbours,
                           int cut) {
  const auto [near, far] = plates.folds[cut];
  std::vector<char> side(plates.corners.size(), 0);
  std::vector<int> open = {far};
  side[far] = 1;
  while (!open.empty()) {
    const int plate = open.back();
    open.pop_back();
    for (const int next : neighbours[plate]) {
      if (side[next] || (plate == far && next == near)) continue;
      side[next] = 1;
      open.push_back(next);
    }
  }
  return side;
}

/// How many rooms a piece of this hull takes up: 1 if it fits, and above that its box over the room
/// in each direction, at the best turn. No whole number, so that smaller counts as better.
double rooms_taken(const std::vector<Vec2>& points, const Extent& room) {
  double least = std::numeric_limits<double>::infinity();
  for (const Turn& turn : upright_turns(convex_hull(points))) {
    if (fits(turn, room)) return 1;
    const double across = std::max(1.0, turn.box.width / room.width);
    const double up = std::max(1.0, turn.box.height / room.height);
    least = std::min(least, across * up);
  }
  // What does not fit becomes two pieces at least.
  return 1 + least;
}

}  // namespace

int choose_cut(const Plates& plates, const Extent& room) {
  std::vector<std::vector<int>> neighbours(plates.corners.size());
  for (const auto& [a, b] : plates.folds) {
    neighbours[a].push_back(b);
    neighbours[b].push_back(a);
  }
  int chosen = -1;
  std::pair<double, double> least;
  for (int cut = 0; cut < static_cast<int>(plates.folds.size()); ++cut) {
    const std::vector<char> side = far_side(plates, neighbours, cut);
    std::array<std::vector<Vec2>, 2> points;
    std::array<double, 2> areas = {0, 0};
    for (std::size_t plate = 0; plate < side.size(); ++plate) {
      const std::vector<Vec2>& corners = plates.corners[plate];
      const int half = side[plate];
      points[half].insert(points[half].end(), corners.begin(), corners.end());
      areas[half] += plates.areas[plate];
    }
    const std::pair cost(rooms_taken(points[0], room) + rooms_taken(points[1], room),
                         std::abs(areas[0] - areas[1]));
    if (chosen == -1 || cost < least) chosen = cut, least = cost;
  }
  return chosen;
}

}  // namespace foldwright
