#include "paper/tape_marks.h"

#include <algorithm>

namespace foldwright {
namespace {

constexpr double kLength = 1.2;  // mm; long enough to see, short enough for slim faces
constexpr double kApart = 0.9;   // of the two strokes, so that they are no dirt
constexpr double kFromEdge = 0.15;
constexpr int kPlaces = 15;

/// The two strokes on one side, around a point of the edge given by its share of the length.
std::array<Stroke, 2> marks_at(const SeamSide& side, double share, double length) {
  std::array<Stroke, 2> marks;
  for (const int i : {0, 1}) {
    const double x = share * side.length() + (i - 0.5) * kApart;
    // y points outwards.
    marks[i] = {side.global({x, -kFromEdge}), side.global({x, -kFromEdge - length})};
  }
  return marks;
}

/// How high the panel of a side is over both strokes.
double room_over(const SeamSide& side, double share) {
  const double x = share * side.length();
  const auto height = [&](double at) { return height_at(side.panel, side.length(), at); };
  return std::min(height(x - 0.5 * kApart), height(x + 0.5 * kApart));
}

}  // namespace

std::array<std::vector<Stroke>, 2> tape_marks(const Seam& seam,
                                              std::array<const LabelSpace*, 2> spaces) {
  std::array<std::vector<Stroke>, 2> marks;
  const double reach = 0.5 - kApart / seam.sides[0].length();
  if (reach <= 0) return marks;
  for (int i = 0; i < kPlaces; ++i) {
    const int step = (i + 1) / 2 * (i % 2 == 0 ? 1 : -1);
    const double share = 0.5 + 2 * reach * step / kPlaces;
    // The edges run against each other.
    const std::array<double, 2> shares = {share, 1 - share};
    std::array<std::array<Stroke, 2>, 2> tried;
    bool is_free = true;
    for (const int s : {0, 1}) {
      const double room = room_over(seam.sides[s], shares[s]);
      const double length = std::min(kLength, 0.6 * room - kFromEdge);
      is_free = is_free && length > 0.3 * kLength;
      if (!is_free) break;
      tried[s] = marks_at(seam.sides[s], shares[s], length);
      for (const Stroke& stroke : tried[s]) is_free = is_free && spaces[s]->is_open(stroke);
    }
    if (!is_free) continue;
    for (const int s : {0, 1}) marks[s].assign(tried[s].begin(), tried[s].end());
    return marks;
  }
  return marks;
}

}  // namespace foldwright
