#include "paper/flap_cover.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace foldwright {
namespace {

// What is no higher above the base than this lies on it; mm.
constexpr double kOnBase = 1e-7;

}  // namespace

void CoverBuilder::add_at_end(int end, const Vec2& tip) {
  if (tip.y() <= kOnBase) return;
  cover_.lean[end] = (end == 0 ? tip.x() : length_ - tip.x()) / tip.y();
}

void CoverBuilder::add(const Vec2& from, const Vec2& to) {
  const bool is_above = std::max(from.y(), to.y()) > kOnBase;
  const bool is_over = std::max(from.x(), to.x()) > 0 && std::min(from.x(), to.x()) < length_;
  if (is_above && is_over) cover_.borders.push_back({from, to});
}

FlapCover seen_back(FlapCover cover, double length) {
  std::swap(cover.lean[0], cover.lean[1]);
  for (auto& border : cover.borders) {
    for (Vec2& p : border) p.x() = length - p.x();
  }
  return cover;
}

double height_at(const FlapCover& cover, double length, double x) {
  double height = std::numeric_limits<double>::infinity();
  const std::array<double, 2> from_ends = {x, length - x};
  for (const int end : {0, 1}) {
    if (cover.lean[end] > 0) height = std::min(height, from_ends[end] / cover.lean[end]);
  }
  for (const auto& [a, b] : cover.borders) {
    const double width = b.x() - a.x();
    const double share = width == 0 ? 0 : (x - a.x()) / width;
    const bool is_over = width == 0 ? x == a.x() : share >= 0 && share <= 1;
    if (is_over) height = std::min(height, a.y() + share * (b.y() - a.y()));
  }
  return height;
}

}  // namespace foldwright
