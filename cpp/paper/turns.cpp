#include "paper/turns.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace foldwright {
namespace {

constexpr int kDiagonalSteps = 60;  // of half a turn: 3 degrees each

Extent turned_box(std::span<const Vec2> points, double c, double s) {
  Vec2 low(1e300, 1e300);
  Vec2 high = -low;
  for (const Vec2& p : points) {
    const Vec2 q(c * p.x() - s * p.y(), s * p.x() + c * p.y());
    low = low.cwiseMin(q);
    high = high.cwiseMax(q);
  }
  return {high.x() - low.x(), high.y() - low.y()};
}

}  // namespace

std::vector<Vec2> convex_hull(std::vector<Vec2> points) {
  std::sort(points.begin(), points.end(), [](const Vec2& a, const Vec2& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  });
  std::vector<Vec2> hull;
  const auto extend = [&](auto begin, auto end) {
    const std::size_t base = hull.size();
    for (auto it = begin; it != end; ++it) {
      while (hull.size() >= base + 2 &&
             cross(hull.back() - hull[hull.size() - 2], *it - hull.back()) <= 0) {
        hull.pop_back();
      }
      hull.push_back(*it);
    }
    hull.pop_back();
  };
  extend(points.begin(), points.end());
  extend(points.rbegin(), points.rend());
  return hull;
}

std::vector<Turn> upright_turns(std::span<const Vec2> hull) {
  std::vector<Turn> turns;
  const auto add = [&](double c, double s) { turns.push_back({c, s, turned_box(hull, c, s)}); };
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Vec2 along = (hull[(i + 1) % hull.size()] - hull[i]).normalized();
    add(along.x(), -along.y());
    add(along.y(), along.x());
  }
  for (int step = 0; step < kDiagonalSteps; ++step) {
    const double angle = step * std::numbers::pi / kDiagonalSteps;
    add(std::cos(angle), std::sin(angle));
  }
  return turns;
}

RigidMotion2 turn_to_origin(std::span<const Vec2> hull, const Turn& turn) {
  RigidMotion2 motion{turn.c, turn.s, Vec2::Zero()};
  Vec2 low(1e300, 1e300);
  for (const Vec2& p : hull) low = low.cwiseMin(motion(p));
  motion.t = -low;
  return motion;
}

Turn turned(std::span<const Vec2> points, const Turn& turn) {
  return {turn.c, turn.s, turned_box(points, turn.c, turn.s)};
}

bool fits(const Extent& box, const Extent& room) {
  return box.width <= room.width + kFitTolerance && box.height <= room.height + kFitTolerance;
}

}  // namespace foldwright
