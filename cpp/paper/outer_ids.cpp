#include "paper/outer_ids.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "geometry/convex2.h"

namespace foldwright {
namespace {

// Between a text and whatever else there is: half a cut, and a pair of scissors that cuts askew.
constexpr double kClearance = 0.4;

// Distance of the places that are tried, and how far they go; see `CalloutFinder`.
constexpr double kStep = 0.8;
constexpr double kReach = 12;

// Between the end of a line and the edge that it leads to, and half of what is kept free along it.
constexpr double kToEdge = 0.3;
constexpr double kLineRoom = 0.15;

constexpr int kPlacesPerEdge = 9;

// Cells about as large as texts.
constexpr double kCell = 4;

Vec2 outwards(const Stroke& edge) {
  const Vec2 along = (edge.to - edge.from).normalized();
  return {along.y(), -along.x()};
}

std::vector<Vec2> make_offsets() {
  std::vector<Vec2> offsets;
  const int steps = static_cast<int>(kReach / kStep);
  for (int y = -steps; y <= steps; ++y) {
    for (int x = -steps; x <= steps; ++x) {
      const Vec2 offset = kStep * Vec2(x, y);
      if (offset.norm() <= kReach) offsets.push_back(offset);
    }
  }
  std::ranges::sort(offsets, {}, [](const Vec2& o) { return std::tuple(o.norm(), o.y(), o.x()); });
  return offsets;
}

}  // namespace

OuterIdFinder::OuterIdFinder(const Surroundings& around)
    : around_(around), grid_(static_cast<int>(around.obstacles.size()) + 1, kCell) {
  for (std::size_t i = 0; i < around.obstacles.size(); ++i) {
    grid_.insert(static_cast<int>(i), around.obstacles[i].box);
  }
}

std::optional<Callout> OuterIdFinder::beside(const Stroke& edge, const std::string& text,
                                             std::span<const double> sizes) const {
  const Vec2 along = (edge.to - edge.from).normalized();
  const double length = (edge.to - edge.from).norm();
  for (const double size : sizes) {
    TextBox box = box_around(text, {size, kClearance}, edge.from, along);
    const double spare = length - 2 * box.half_width;
    if (spare < 0) continue;
    for (int i = 0; i < kPlacesPerEdge; ++i) {
      // From the middle to both ends in turn.
      const int step = (i + 1) / 2 * (i % 2 == 0 ? 1 : -1);
      const double x = 0.5 * length + spare * step / (kPlacesPerEdge - 1);
      box.centre = edge.from + x * along + (box.half_height + 1e-6) * outwards(edge);
      if (is_free(box)) return Callout{box, size, {box.centre, box.centre}};
    }
  }
  return std::nullopt;
}

std::optional<Callout> OuterIdFinder::apart(const Stroke& edge, const std::string& text,
                                            std::span<const double> sizes) const {
  static const std::vector<Vec2> offsets = make_offsets();
  const Vec2 along = (edge.to - edge.from).normalized();
  const Vec2 middle = 0.5 * (edge.from + edge.to);
  const Vec2 end = middle + kToEdge * outwards(edge);
  for (const Vec2& offset : offsets) {
    if (offset.dot(outwards(edge)) <= 0) continue;
    for (const double size : sizes) {
      for (const Vec2& direction : {along, Vec2(1, 0)}) {
        const TextBox box = box_around(text, {size, kClearance}, middle + offset, direction);
        if (!is_free(box)) continue;
        const Stroke leader = {exit_of(box, end), end};
        if (is_open(leader)) return Callout{box, size, leader};
      }
    }
  }
  return std::nullopt;
}

void OuterIdFinder::take(const TextBox& text) {
  const auto corners = text.corners();
  const int item = static_cast<int>(around_.obstacles.size() + texts_.size());
  texts_.push_back({{corners.begin(), corners.end()}, box_of(corners), -1});
  grid_.insert(item, texts_.back().box);
}

bool OuterIdFinder::is_free(const TextBox& text) const {
  const auto corners = text.corners();
  const Box2 box = box_of(corners);
  for (int i = 0; i < 2; ++i) {
    if (box.min[i] < around_.paper.min[i] || box.max[i] > around_.paper.max[i]) return false;
  }
  return is_clear(corners);
}

bool OuterIdFinder::is_open(const Stroke& leader) const {
  const Vec2 way = leader.to - leader.from;
  if (way.norm() < 1e-9) return true;
  const Vec2 across = kLineRoom * Vec2(-way.y(), way.x()).normalized();
  return is_clear(std::array<Vec2, 4>{leader.from - across, leader.to - across, leader.to + across,
                                      leader.from + across});
}

bool OuterIdFinder::is_clear(std::span<const Vec2> polygon) const {
  const Box2 box = box_of(polygon);
  const auto known = static_cast<int>(around_.obstacles.size());
  bool is_clear = true;
  grid_.visit(box, [&](int i) {
    const Obstacle& obstacle = i < known ? around_.obstacles[i] : texts_[i - known];
    is_clear = !obstacle.box.meets(box) || !convex_overlap(polygon, obstacle.polygon, 0);
    return is_clear;
  });
  return is_clear;
}

}  // namespace foldwright
