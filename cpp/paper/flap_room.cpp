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

/// Lowers a profile below obstacles beside its base.
void lower_below(RoomProfile& profile, const SeamFrame& frame,
                 std::span<const Obstacle* const> obstacles) {
  Polygon local;
  for (const Obstacle* obstacle : obstacles) {
    local.clear();
    for (const Vec2& p : obstacle->polygon) local.push_back(frame.local(p));
    // What touches the base from below, as the faces of its own panel do, is no roof over it.
    const auto is_below = [](const Vec2& p) { return p.y() <= kTouching; };
    if (!std::ranges::all_of(local, is_below)) lower_below(profile, local);
  }
}

/// The best flap below a profile that all obstacles but their insides are taken from.
std::optional<Trapezoid> best_below(RoomProfile profile, const SeamSide& side,
                                    const FlapCover& cover, const FlapShape& shape,
                                    std::span<const Obstacle* const> obstacles) {
  lower_below(profile, cover);
  const auto found = best_flap(profile, cover.lean, shape);
  // The profile sees the outlines of what is in the way, not what covers the base altogether.
  if (!found || !is_free(side, *found, obstacles)) return std::nullopt;
  return widened(side, *found, cover, obstacles);
}

RoomProfile fine_room(const SeamSide& side, double height) {
  return open_room(side.length(), height, kFineBin);
}

}  // namespace

std::vector<Vec2> flap_corners(const SeamSide& side, const Trapezoid& flap) {
  const auto [first, last, far, near] = flap.corners();
  const SeamFrame frame = side.frame();
  return {frame.global(first), frame.global(near), frame.global(far), frame.global(last)};
}

FlapRoom::FlapRoom(std::span<const Net> nets, std::span<const std::vector<Polygon>> keep_off)
    : nets_(nets) {
  for (std::size_t n = 0; n < nets.size(); ++n) {
    const Net& net = nets[n];
    const int faces = static_cast<int>(net.corners.size());
    Obstacles fixed = {{}, BoxGrid<2>(faces, kGridCell)};
    for (const auto& [a, b, c] : net.corners) {
      fixed.add({net.vertices[a], net.vertices[b], net.vertices[c]});
    }
    if (n < keep_off.size()) {
      for (const Polygon& polygon : keep_off[n]) fixed.add(polygon);
    }
    obstacles_.push_back({std::move(fixed), {{}, BoxGrid<2>(faces, kGridCell)}});
  }
}

FlapRoom::Site FlapRoom::site_of(const SeamSide& side, double height) const {
  const Box2 reach = box_of(std::array{side.from, side.to}).grown(height + 1);
  Site site = {&side, reach, obstacles_[side.net].fixed.near(reach), fine_room(side, height)};
  std::erase_if(site.fixed,
                [&](int i) { return std::ranges::find(side.faces, i) != side.faces.end(); });
  lower_below(site.below_fixed, side.frame(), fixed_near(site));
  return site;
}

std::optional<Trapezoid> FlapRoom::best(const Site& site, const FlapCover& cover,
                                        const FlapShape& shape) const {
  RoomProfile profile = site.below_fixed;
  Pointers obstacles = taken_near(site);
  lower_below(profile, site.side->frame(), obstacles);
  const Pointers fixed = fixed_near(site);
  obstacles.insert(obstacles.end(), fixed.begin(), fixed.end());
  return best_below(std::move(profile), *site.side, cover, shape, obstacles);
}

FlapMiss FlapRoom::why_none(const Site& site, const FlapCover& cover,
                            const FlapShape& shape) const {
  const SeamSide& side = *site.side;
  if (side.length() < shortest_base(shape)) return FlapMiss::kShort;
  RoomProfile profile = fine_room(side, shape.height);
  if (!best_below(profile, side, cover, shape, {})) return FlapMiss::kThin;
  Pointers beside;
  for (const int i : site.fixed) {
    const Obstacle& obstacle = obstacles_[side.net].fixed.all[i];
    const bool touches = std::ranges::any_of(
        obstacle.polygon, [&](const Vec2& p) { return p == side.from || p == side.to; });
    if (touches && is_face(side.net, i)) beside.push_back(&obstacle);
  }
  lower_below(profile, side.frame(), beside);
  const auto flap = best_below(std::move(profile), side, cover, shape, beside);
  return flap ? FlapMiss::kBlocked : FlapMiss::kNarrow;
}

Trapezoid FlapRoom::set_apart(const Site& site, const FlapCover& cover,
                              const Trapezoid& flap) const {
  const SeamSide& side = *site.side;
  FlapNeighbours neighbours;
  Pointers obstacles = fixed_near(site);
  for (std::size_t i = 0; i < site.fixed.size(); ++i) {
    auto& kind = is_face(side.net, site.fixed[i]) ? neighbours.faces : neighbours.flaps;
    kind.emplace_back(obstacles[i]->polygon);
  }
  for (const Obstacle* taken : taken_near(site)) {
    neighbours.flaps.emplace_back(taken->polygon);
    obstacles.push_back(taken);
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

bool FlapRoom::is_face(int net, int fixed) const {
  return fixed < static_cast<int>(nets_[net].corners.size());
}

int FlapRoom::take(const SeamSide& side, const Trapezoid& flap) {
  return obstacles_[side.net].taken.add(flap_corners(side, flap));
}

void FlapRoom::give_back(const SeamSide& side, int taken) {
  Obstacles& flaps = obstacles_[side.net].taken;
  flaps.grid.remove(taken, flaps.all[taken].box);
}

FlapRoom::Pointers FlapRoom::fixed_near(const Site& site) const {
  const std::vector<Obstacle>& all = obstacles_[site.side->net].fixed.all;
  Pointers pointers;
  for (const int i : site.fixed) pointers.push_back(&all[i]);
  return pointers;
}

FlapRoom::Pointers FlapRoom::taken_near(const Site& site) const {
  const Obstacles& taken = obstacles_[site.side->net].taken;
  Pointers pointers;
  for (const int i : taken.near(site.reach)) pointers.push_back(&taken.all[i]);
  return pointers;
}

int FlapRoom::Obstacles::add(Polygon polygon) {
  const int index = static_cast<int>(all.size());
  const Box2 box = box_of(polygon);
  grid.insert(index, box);
  all.push_back({std::move(polygon), box});
  return index;
}

std::vector<int> FlapRoom::Obstacles::near(const Box2& reach) const {
  std::vector<int> found;
  grid.visit(reach, [&](int i) {
    if (all[i].box.meets(reach)) found.push_back(i);
    return true;
  });
  std::ranges::sort(found);
  found.erase(std::ranges::unique(found).begin(), found.end());
  return found;
}

}  // namespace foldwright
