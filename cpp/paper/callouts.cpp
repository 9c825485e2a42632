#include "paper/callouts.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "geometry/convex2.h"

namespace foldwright {
namespace {

// Distance of the points that are tried; half the height of a text.
constexpr double kStep = 0.6;
// Longer lines are hard to follow among folds.
constexpr double kReach = 12;
// Between the end of a line and the edge that it leads to.
constexpr double kToEdge = 0.25;

Box2 box_of_net(const Net& net) { return box_of(net.vertices); }

}  // namespace

CalloutFinder::CalloutFinder(const Net& net, double least_size, double clearance)
    : net_(net),
      least_size_(least_size),
      clearance_(clearance),
      faces_(static_cast<int>(net.corners.size()), 2 * kReach / 3) {
  const Box2 box = box_of_net(net);
  origin_ = {box.min[0], box.min[1]};
  columns_ = static_cast<int>((box.max[0] - box.min[0]) / kStep) + 1;
  rows_ = static_cast<int>((box.max[1] - box.min[1]) / kStep) + 1;
  points_.assign(static_cast<std::size_t>(columns_) * rows_, Point::kUnknown);
  for (std::size_t face = 0; face < net.corners.size(); ++face) {
    const auto& [a, b, c] = net.corners[face];
    faces_.insert(static_cast<int>(face),
                  box_of(std::array{net.vertices[a], net.vertices[b], net.vertices[c]}));
  }
  const int steps = static_cast<int>(kReach / kStep);
  for (int y = -steps; y <= steps; ++y) {
    for (int x = -steps; x <= steps; ++x) {
      const double distance = kStep * std::hypot(x, y);
      if (distance <= kReach) offsets_.push_back({distance, x, y});
    }
  }
  std::ranges::sort(offsets_, {}, [](const Offset& o) { return std::tuple(o.distance, o.y, o.x); });
}

std::optional<Callout> CalloutFinder::find(const LabelSpace& space, const SeamSide& side,
                                           const std::string& text, std::span<const double> sizes) {
  const Vec2 middle = 0.5 * (side.from + side.to);
  const int x0 = static_cast<int>(std::lround((middle.x() - origin_.x()) / kStep));
  const int y0 = static_cast<int>(std::lround((middle.y() - origin_.y()) / kStep));
  for (const auto& [distance, dx, dy] : offsets_) {
    const Vec2 centre = origin_ + kStep * Vec2(x0 + dx, y0 + dy);
    if (cross(side.to - side.from, centre - side.from) <= 0) continue;
    if (!is_open(space, x0 + dx, y0 + dy)) continue;
    if (auto found = try_at(space, side, text, centre, sizes)) return found;
  }
  return std::nullopt;
}

bool CalloutFinder::is_inside(const Vec2& p) const {
  bool is_inside = false;
  const Box2 at = {{p.x(), p.y()}, {p.x(), p.y()}};
  faces_.visit(at, [&](int face) {
    const auto& corners = net_.corners[face];
    is_inside = true;
    for (int i = 0; i < 3; ++i) {
      const Vec2& from = net_.vertices[corners[i]];
      is_inside = is_inside && cross(net_.vertices[corners[(i + 1) % 3]] - from, p - from) >= 0;
    }
    return !is_inside;
  });
  return is_inside;
}

/// Whether the least text could stand there if it were no wider than high.
bool CalloutFinder::is_open(const LabelSpace& space, int x, int y) {
  if (x < 0 || y < 0 || x >= columns_ || y >= rows_) return false;
  Point& point = points_[static_cast<std::size_t>(y) * columns_ + x];
  if (point == Point::kUnknown) {
    const Vec2 p = origin_ + kStep * Vec2(x, y);
    // Whatever its turn, the text holds the square within the circle of half its height.
    const double half = std::sqrt(0.5) * (0.5 * kCapHeight * least_size_ + clearance_);
    const bool is_open = is_inside(p) && space.is_free({p, {1, 0}, half, half});
    point = is_open ? Point::kOpen : Point::kTaken;
  }
  return point == Point::kOpen;
}

std::optional<Callout> CalloutFinder::try_at(const LabelSpace& space, const SeamSide& side,
                                             const std::string& text, const Vec2& centre,
                                             std::span<const double> sizes) const {
  const Vec2 edge = (side.to - side.from).normalized();
  const Vec2 end = 0.5 * (side.from + side.to) + kToEdge * Vec2(-edge.y(), edge.x());
  const std::array<Vec2, 3> directions = {edge, Vec2(1, 0), Vec2(0, 1)};
  const auto box_of_size = [&](double size, const Vec2& along) {
    return box_around(text, {size, clearance_}, centre, along);
  };
  // Where the least text does not stand, no larger one does: most places end here.
  std::array<bool, 3> has_room;
  std::ranges::transform(directions, has_room.begin(), [&](const Vec2& along) {
    return space.is_free(box_of_size(sizes.back(), along));
  });
  for (const double size : sizes) {
    for (std::size_t i = 0; i < directions.size(); ++i) {
      if (!has_room[i]) continue;
      const TextBox box = box_of_size(size, directions[i]);
      if (!space.is_free(box)) continue;
      const Stroke leader = {exit_of(box, end), end};
      if (space.is_open(leader)) return Callout{box, size, leader};
    }
  }
  return std::nullopt;
}

}  // namespace foldwright
