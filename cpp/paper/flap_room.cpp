#include "paper/flap_room.h"

#include <algorithm>

#include "geometry/convex2.h"
#include "paper/flap_gaps.h"

namespace foldwright {
namespace {

// Flaps may touch what is beside them in a point of the outline, up to rounding.
constexpr double kTouching = 1e-6;

// Side of a grid's cells in mm, about that of faces.
constexpr double kGridCell = 8;

using Polygon = FlapRoom::Polygon;
using Obstacle = FlapRoom::Obstacle;

bool is_free(const SeamSide& side, const Trapezoid& flap,
             std::span<const Obstacle* const> obstacles) {
  const Polygon corners = flap_corners(side, flap);
  const Box2 box = box_of(corners);
  return std::ranges::none_of(obstacles, [&](const Obstacle* obstacle) {
    return box.meets(obstacle->box) && convex_overlap(corners, obstacle->polygon, kTouching);
  });
}

/// Whether a flap on a base of some length stays within its cover.
bool is_covered(const Trapezoid& flap, double length, const FlapCover& cover) {
  const auto& [first, second] = cover.lean;
  if (flap.top[0] < first * flap.height - kTouching) return false;
  if (flap.top[1] > length - second * flap.height + kTouching) return false;
  return std::ranges::none_of(cover.borders, [&](const std::array<Vec2, 2>& border) {
    return convex_overlap(flap.corners(), border, kTouching);
  });
}

/// The flap with its feet at the ends of the edge where nothing is in the way: the profile is too
/// coarse to tell next to a corner.
Trapezoid widened(const SeamSide& side, Trapezoid flap, const FlapCover& cover,
                  std::span<const Obstacle* const> obstacles) {
  for (const int end : {0, 1}) {
    Trapezoid wider = flap;
    wider.foot[end] = end == 0 ? 0 : side.length();
    if (is_free(side, wider, obstacles) && is_covered(wider, side.length(), cover)) flap = wider;
  }
  return flap;
}

}  // namespace

std::vector<Vec2> flap_corners(const SeamSide& side, const Trapezoid& flap) {
  const auto [first, last, far, near] = flap.corners();
  const SeamFrame frame = side.frame();
  return {frame.global(first), frame.global(near), frame.global(far), frame.global(last)};
}

FlapRoom::FlapRoom(std::span<const Net> nets, std::span<const std::vector<Polygon>> keep_off)
    : nets_(nets) {
  for (const Net& net : nets) {
    const int n = static_cast<int>(obstacles_.size());
    obstacles_.push_back({{}, BoxGrid<2>(static_cast<int>(net.corners.size()), kGridCell)});
    for (const auto& [a, b, c] : net.corners) {
      add(n, {net.vertices[a], net.vertices[b], net.vertices[c]});
    }
  }
  for (std::size_t n = 0; n < keep_off.size(); ++n) {
    for (const Polygon& polygon : keep_off[n]) add(static_cast<int>(n), polygon);
  }
}

std::optional<Trapezoid> FlapRoom::best(const SeamSide& side, const FlapCover& cover,
                                        const FlapShape& shape) const {
  return best(side, cover, shape, near(side, shape.height));
}

FlapMiss FlapRoom::why_none(const SeamSide& side, const FlapCover& cover,
                            const FlapShape& shape) const {
  if (side.length() < shortest_base(shape)) return FlapMiss::kShort;
  if (!best(side, cover, shape, {})) return FlapMiss::kThin;
  std::vector<const Obstacle*> beside;
  for (const Obstacle* obstacle : near(side, shape.height)) {
    const bool touches = std::ranges::any_of(
        obstacle->polygon, [&](const Vec2& p) { return p == side.from || p == side.to; });
    if (touches && is_face(side.net, obstacle)) beside.push_back(obstacle);
  }
  return best(side, cover, shape, beside) ? FlapMiss::kBlocked : FlapMiss::kNarrow;
}

Trapezoid FlapRoom::set_apart(const SeamSide& side, const FlapCover& cover,
                              const Trapezoid& flap) const {
  const std::vector<const Obstacle*> obstacles = near(side, flap.height);
  FlapNeighbours neighbours;
  for (const Obstacle* obstacle : obstacles) {
    auto& kind = is_face(side.net, obstacle) ? neighbours.faces : neighbours.flaps;
    kind.emplace_back(obstacle->polygon);
  }
  Trapezoid own = flap;
  for (const int end : {0, 1}) {
    const auto laid = laid_on(side, own, end, neighbours);
    const bool fits =
        laid && is_free(side, *laid, obstacles) && is_covered(*laid, side.length(), cover);
    own = fits ? *laid : drawn_in(side, own, end, neighbours);
  }
  return own;
}

bool FlapRoom::is_face(int net, const Obstacle* obstacle) const {
  const auto index = obstacle - obstacles_[net].all.data();
  return index < static_cast<std::ptrdiff_t>(nets_[net].corners.size());
}

int FlapRoom::take(const SeamSide& side, const Trapezoid& flap) {
  return add(side.net, flap_corners(side, flap));
}

void FlapRoom::give_back(const SeamSide& side, int taken) {
  Obstacles& obstacles = obstacles_[side.net];
  obstacles.grid.remove(taken, obstacles.all[taken].box);
}

int FlapRoom::add(int net, Polygon polygon) {
  Obstacles& obstacles = obstacles_[net];
  const int index = static_cast<int>(obstacles.all.size());
  const Box2 box = box_of(polygon);
  obstacles.grid.insert(index, box);
  obstacles.all.push_back({std::move(polygon), box});
  return index;
}

/// Obstacles near the base of a flap so high, without the faces it belongs to.
std::vector<const FlapRoom::Obstacle*> FlapRoom::near(const SeamSide& side, double height) const {
  const Box2 reach = box_of(std::array{side.from, side.to}).grown(height + 1);
  const Obstacles& obstacles = obstacles_[side.net];
  std::vector<int> found;
  obstacles.grid.visit(reach, [&](int i) {
    if (obstacles.all[i].box.meets(reach)) found.push_back(i);
    return true;
  });
  std::ranges::sort(found);
  found.erase(std::ranges::unique(found).begin(), found.end());
  std::vector<const Obstacle*> near;
  near.reserve(found.size());
  for (const int i : found) {
    const bool is_own = std::ranges::find(side.faces, i) != side.faces.end();
    if (!is_own) near.push_back(&obstacles.all[i]);
  }
  return near;
}

std::optional<Trapezoid> FlapRoom::best(const SeamSide& side, const FlapCover& cover,
                                        const FlapShape& shape,
                                        std::span<const Obstacle* const> obstacles) {
  RoomProfile profile = open_room(side.length(), shape.height, kFineBin);
  const SeamFrame frame = side.frame();
  Polygon local;
  for (const Obstacle* obstacle : obstacles) {
    local.clear();
    for (const Vec2& p : obstacle->polygon) local.push_back(frame.local(p));
    // What touches the base from below, as the faces of its own panel do, is no roof over it.
    const auto is_below = [](const Vec2& p) { return p.y() <= kTouching; };
    if (!std::ranges::all_of(local, is_below)) lower_below(profile, local);
  }
  lower_below(profile, cover);
  const auto found = best_flap(profile, cover.lean, shape);
  // The profile sees the outlines of what is in the way, not what covers the base altogether.
  if (!found || !is_free(side, *found, obstacles)) return std::nullopt;
  return widened(side, *found, cover, obstacles);
}

}  // namespace foldwright
