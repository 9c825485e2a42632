#include "paper/flaps.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <tuple>

#include "geometry/convex2.h"
#include "paper/outline.h"
#include "paper/seams.h"

namespace foldwright {
namespace {

// Flaps may touch what is beside them in a point of the outline, up to rounding.
constexpr double kTouching = 1e-6;

using Polygon = std::vector<Vec2>;

/// A polygon that a flap must not overlap, in the net's coordinates.
struct Obstacle {
  Polygon corners;
  Box2 box;
};

struct Candidate {
  Trapezoid shape;
  double top() const { return shape.top[1] - shape.top[0]; }
  auto rank() const { return std::tuple(shape.height, top()); }
};

class FlapPlacer {
 public:
  FlapPlacer(const Mesh& mesh, std::span<const Net> nets, const FlapOptions& options,
             std::span<const std::vector<Polygon>> keep_off)
      : mesh_(mesh), nets_(nets), options_(options), seams_(find_seams(nets)) {
    obstacles_.resize(nets.size());
    for (std::size_t n = 0; n < nets.size(); ++n) {
      for (const auto& [a, b, c] : nets[n].corners) {
        const Net& net = nets[n];
        add_obstacle(static_cast<int>(n), {net.vertices[a], net.vertices[b], net.vertices[c]});
      }
    }
    for (std::size_t n = 0; n < keep_off.size(); ++n) {
      for (const Polygon& polygon : keep_off[n]) add_obstacle(static_cast<int>(n), polygon);
    }
    plan_.flaps.resize(nets.size());
  }

  FlapPlan place() {
    if (options_.side == FlapSide::kAlternate) prefer_in_turn();
    for (const int i : by_scarcity()) serve(seams_[i], preferred_.empty() ? -1 : preferred_[i]);
    for (auto& flaps : plan_.flaps) {
      std::ranges::sort(flaps, {}, [](const Flap& flap) { return flap.edge; });
    }
    std::ranges::sort(plan_.missed, {}, [](const MissedFlap& miss) { return miss.mesh_edge; });
    return std::move(plan_);
  }

 private:
  void add_obstacle(int net, Polygon corners) {
    const Box2 box = box_of(corners);
    obstacles_[net].push_back({std::move(corners), box});
  }

  /// Obstacles near the base, without the face it belongs to.
  std::vector<const Obstacle*> near(const SeamSide& side) const {
    const Box2 reach = box_of(std::array{side.from, side.to}).grown(options_.shape.height + 1);
    std::vector<const Obstacle*> found;
    const std::vector<Obstacle>& all = obstacles_[side.net];
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (static_cast<int>(i) != side.face && all[i].box.meets(reach)) found.push_back(&all[i]);
    }
    return found;
  }

  /// The neighbour's third corner, unfolded across the edge.
  static Vec2 apex(const SeamSide& side, const SeamSide& other) {
    const Vec2 p = other.local(other.third);
    return {side.length() - p.x(), -p.y()};
  }

  std::optional<Candidate> best(const SeamSide& side, const SeamSide& other,
                                std::span<const Obstacle* const> obstacles) const {
    RoomProfile profile = open_room(side.length(), options_.shape.height);
    for (const Obstacle* obstacle : obstacles) {
      Polygon local;
      for (const Vec2& p : obstacle->corners) local.push_back(side.local(p));
      lower_below(profile, local);
    }
    const auto found = best_flap(profile, apex(side, other), options_.shape);
    // The profile sees the outlines of what is in the way, not what covers the base altogether.
    if (!found || !is_free(side, *found, obstacles)) return std::nullopt;
    return Candidate{widened(side, *found, obstacles)};
  }

  static Polygon corners_of(const SeamSide& side, const Trapezoid& flap) {
    return {side.global({flap.foot[0], 0}), side.global({flap.top[0], flap.height}),
            side.global({flap.top[1], flap.height}), side.global({flap.foot[1], 0})};
  }

  static bool is_free(const SeamSide& side, const Trapezoid& flap,
                      std::span<const Obstacle* const> obstacles) {
    const Polygon corners = corners_of(side, flap);
    return std::ranges::none_of(obstacles, [&](const Obstacle* obstacle) {
      return convex_overlap(corners, obstacle->corners, kTouching);
    });
  }

  /// The flap with its feet at the ends of the edge where nothing is in the way: the profile is too
  /// coarse to tell next to a corner.
  static Trapezoid widened(const SeamSide& side, Trapezoid flap,
                           std::span<const Obstacle* const> obstacles) {
    for (const int end : {0, 1}) {
      Trapezoid wider = flap;
      wider.foot[end] = end == 0 ? 0 : side.length();
      if (is_free(side, wider, obstacles)) flap = wider;
    }
    return flap;
  }

  /// Seams that have room at all, those with least room first and short edges last.
  std::vector<int> by_scarcity() {
    std::vector<std::tuple<bool, double, double, int>> order;
    for (int i = 0; i < static_cast<int>(seams_.size()); ++i) {
      std::tuple<double, double> most = {0, 0};
      for (const int s : {0, 1}) {
        const SeamSide& side = seams_[i].sides[s];
        const auto found = best(side, seams_[i].sides[1 - s], near(side));
        if (found) most = std::max(most, std::tuple(found->rank()));
      }
      const bool is_short = seams_[i].sides[0].length() <= kWantedLength;
      order.emplace_back(is_short, std::get<0>(most), std::get<1>(most), i);
    }
    std::ranges::sort(order);
    std::vector<int> seams;
    for (const auto& entry : order) seams.push_back(std::get<3>(entry));
    return seams;
  }

  /// Along each outline, flaps are preferred on every other edge that has no preference yet.
  void prefer_in_turn() {
    std::vector<std::vector<std::pair<int, int>>> seam_of(nets_.size());  // seam, side; by edge
    for (std::size_t n = 0; n < nets_.size(); ++n)
      seam_of[n].resize(nets_[n].edges.size(), {-1, 0});
    for (int i = 0; i < static_cast<int>(seams_.size()); ++i) {
      for (const int s : {0, 1}) {
        const SeamSide& side = seams_[i].sides[s];
        seam_of[side.net][side.edge] = {i, s};
      }
    }
    preferred_.assign(seams_.size(), -1);
    for (std::size_t n = 0; n < nets_.size(); ++n) {
      std::vector<int> edge_from(nets_[n].vertices.size(), -1);
      for (std::size_t e = 0; e < nets_[n].edges.size(); ++e) {
        if (seam_of[n][e].first != -1) {
          edge_from[nets_[n].edges[e].vertices[0]] = static_cast<int>(e);
        }
      }
      bool here = true;
      for (const std::vector<int>& walk : boundary_walks(nets_[n])) {
        for (const int vertex : walk) {
          if (edge_from[vertex] == -1) continue;
          const auto [seam, side] = seam_of[n][edge_from[vertex]];
          // An edge that another piece decided about sets the turn, too.
          if (preferred_[seam] == -1) preferred_[seam] = here ? side : 1 - side;
          here = preferred_[seam] != side;
        }
      }
    }
  }

  void serve(const Seam& seam, int preferred) {
    std::array<std::optional<Candidate>, 2> found;
    for (const int s : {0, 1}) {
      found[s] = best(seam.sides[s], seam.sides[1 - s], near(seam.sides[s]));
    }
    const auto height = [&](int s) { return found[s] ? found[s]->shape.height : 0.0; };
    int chosen = found[1] && (!found[0] || found[1]->rank() > found[0]->rank()) ? 1 : 0;
    if (preferred != -1 && height(preferred) >= height(1 - preferred)) chosen = preferred;
    count(seam, std::max(height(0), height(1)));
    if (found[chosen]) add_flap(seam, chosen, found[chosen]->shape);
    if (options_.side != FlapSide::kBoth) return;
    // A slit has both sides in one net, so that the first flap may be in the way of the second.
    const int other = 1 - chosen;
    const auto again = best(seam.sides[other], seam.sides[chosen], near(seam.sides[other]));
    if (again) add_flap(seam, other, again->shape);
  }

  void add_flap(const Seam& seam, int s, const Trapezoid& shape) {
    const SeamSide& side = seam.sides[s];
    const Polygon corners = corners_of(side, shape);
    plan_.flaps[side.net].push_back({side.edge,
                                     {corners[0], corners[1], corners[2], corners[3]},
                                     shape.height,
                                     fold_angle(mesh_, seam.mesh_edge)});
    add_obstacle(side.net, corners);
  }

  void count(const Seam& seam, double height) {
    const double length = seam.sides[0].length();
    if (length <= kWantedLength) return;
    FlapCounts& counts = plan_.counts;
    ++counts.wanted;
    counts.wanted_length += length;
    if (height == 0) {
      counts.missing_length += length;
      plan_.missed.push_back({seam.mesh_edge, why_missed(seam)});
    } else {
      ++(height >= options_.shape.height ? counts.full : counts.shrunk);
    }
  }

  FlapMiss why_missed(const Seam& seam) const {
    FlapMiss why = FlapMiss::kShort;
    for (const int s : {0, 1}) why = std::max(why, why_missed(seam.sides[s], seam.sides[1 - s]));
    return why;
  }

  /// What keeps a side from a flap, the first of the reasons in their order.
  FlapMiss why_missed(const SeamSide& side, const SeamSide& other) const {
    if (side.length() < shortest_base(options_.shape)) return FlapMiss::kShort;
    if (!best(side, other, {})) return FlapMiss::kThin;
    std::vector<const Obstacle*> beside;
    for (const Obstacle* obstacle : near(side)) {
      const bool touches = std::ranges::any_of(
          obstacle->corners, [&](const Vec2& p) { return p == side.from || p == side.to; });
      const auto index = obstacle - obstacles_[side.net].data();
      const bool is_face = index < static_cast<std::ptrdiff_t>(nets_[side.net].corners.size());
      if (touches && is_face) beside.push_back(obstacle);
    }
    return best(side, other, beside) ? FlapMiss::kBlocked : FlapMiss::kNarrow;
  }

  const Mesh& mesh_;
  std::span<const Net> nets_;
  FlapOptions options_;
  std::vector<Seam> seams_;
  std::vector<int> preferred_;                    ///< per seam, the side, for alternating flaps
  std::vector<std::vector<Obstacle>> obstacles_;  ///< per net: its faces, then the flaps placed
  FlapPlan plan_;
};

}  // namespace

FlapPlan place_flaps(const Mesh& mesh, std::span<const Net> nets, const FlapOptions& options,
                     std::span<const std::vector<std::vector<Vec2>>> keep_off) {
  if (options.side == FlapSide::kNone) {
    FlapPlan none;
    none.flaps.resize(nets.size());
    return none;
  }
  return FlapPlacer(mesh, nets, options, keep_off).place();
}

}  // namespace foldwright
