#include "paper/flaps.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <tuple>

#include "paper/flap_runs.h"
#include "paper/flap_sides.h"
#include "paper/flap_wishes.h"
#include "paper/seams.h"

namespace foldwright {
namespace {

std::tuple<double, double> rank_of(const std::optional<Trapezoid>& flap) {
  if (!flap) return {0, 0};
  return {flap->height, flap->top[1] - flap->top[0]};
}

/// How far a flap at a concave corner leans in per height to leave half of it to the flap of the
/// edge beside it; `out`, `back`: along the two edges away from the corner, the paper on the left
/// of `out`.
std::optional<double> half_corner(const Vec2& out, const Vec2& back) {
  // Of the corner's angle outside the paper, from `out` clockwise to `back`.
  double angle = std::atan2(cross(back, out), back.dot(out));
  if (angle < 0) angle += 2 * std::numbers::pi;
  if (angle >= std::numbers::pi) return std::nullopt;
  return 1 / std::tan(std::max(0.5 * angle, 1e-6));
}

class FlapPlacer {
 public:
  FlapPlacer(const Mesh& mesh, std::span<const Net> nets, const FlapOptions& options,
             std::span<const std::vector<std::vector<Vec2>>> keep_off)
      : mesh_(mesh),
        nets_(nets),
        options_(options),
        panels_(panels_of(nets)),
        seams_(find_seams(nets, panels_)),
        wishes_(mesh, options),
        room_(nets, keep_off),
        sites_(seams_.size()),
        corners_(seams_.size()),
        runs_(find_runs(seams_)),
        chosen_(seams_.size(), -1),
        is_served_(seams_.size(), 0),
        placed_(seams_.size()) {
    find_corners();
  }

  FlapPlan place() {
    choose_sides();
    const std::vector<int> order = by_scarcity();
    for (const int seam : order) {
      serve(seam);
      is_served_[seam] = 1;
    }
    for (const int seam : order) serve_again(seam);
    for (const int seam : order) set_apart(seam);
    finish(order);
    if (options_.borders || !mesh_.joints.empty()) serve_borders();
    for (auto& flaps : plan_.flaps) {
      std::ranges::sort(flaps, {}, [](const Flap& flap) { return flap.edge; });
    }
    std::ranges::sort(plan_.missed, {}, [](const MissedFlap& miss) { return miss.mesh_edge; });
    return std::move(plan_);
  }

 private:
  /// A flap where it is.
  struct PlacedFlap {
    Trapezoid shape;
    int taken;  ///< see `FlapRoom::take`
  };
  /// What a side of a seam meets at a concave corner at one of its ends.
  struct Corner {
    SeamStep other = {-1, 0};  ///< the side beside it
    double lean = 0;           ///< see `half_corner`
  };

  /// Notes where sides of seams meet at concave corners.
  void find_corners() {
    const auto starts = seam_starts(seams_);
    for (int i = 0; i < static_cast<int>(seams_.size()); ++i) {
      for (const int s : {0, 1}) {
        const SeamSide& side = seams_[i].sides[s];
        const auto next = starts.find({side.net, side.base[1]});
        if (next == starts.end()) continue;
        const auto& [j, t] = next->second;
        const SeamSide& beside = seams_[j].sides[t];
        const auto lean = half_corner(beside.to - beside.from, side.from - side.to);
        if (!lean) continue;
        corners_[i][s][1] = {{j, t}, *lean};
        corners_[j][t][0] = {{i, s}, *lean};
      }
    }
  }

  /// How a flap on a side may look.
  FlapShape shape_of(int seam, int s) const {
    FlapShape shape = wishes_.shape_at(seams_[seam].mesh_edges);
    const double length = seams_[seam].sides[s].length();
    if (options_.style == FlapStyle::kEdge || length > kLongestInRun * shape.height) return shape;
    for (const int end : {0, 1}) {
      if (runs_[seam][s][end]) shape.angles[end] = std::max(shape.angles[end], kNotchAngle);
    }
    return shape;
  }

  FlapWish wish_of(const Seam& seam) const { return wishes_.of(seam, nets_); }

  /// The highest flap; at ends where `shares` is set it leaves half of the corner to another one.
  std::optional<Trapezoid> best(int seam, int s, std::array<bool, 2> shares) {
    FlapCover cover = seams_[seam].cover_of(s);
    for (const int end : {0, 1}) {
      if (shares[end]) cover.lean[end] = std::max(cover.lean[end], corners_[seam][s][end].lean);
    }
    const FlapShape shape = shape_of(seam, s);
    const auto flap = room_.best(site(seam, s), cover, shape);
    const bool is_tooth = options_.style == FlapStyle::kZigzag && is_in_run(seam, s) &&
                          seams_[seam].sides[s].length() <= kWidestTooth * shape.height;
    return flap && is_tooth ? tooth_of(*flap) : flap;
  }

  const FlapRoom::Site& site(int seam, int s) {
    auto& known = sites_[seam][s];
    if (!known) known = room_.site_of(seams_[seam].sides[s], shape_of(seam, s).height);
    return *known;
  }

  bool is_in_run(int seam, int s) const { return runs_[seam][s][0] || runs_[seam][s][1]; }

  /// Decides for every seam on which side its flap goes, by the room that faces leave, with corners
  /// shared among seams that are glued in one go.
  void choose_sides() {
    auto chains = seam_chains(seams_);
    std::vector<int> chain_of(seams_.size());
    for (std::size_t c = 0; c < chains.size(); ++c) {
      for (const SeamStep& step : chains[c]) chain_of[step.seam] = static_cast<int>(c);
    }
    heights_.assign(seams_.size(), {-1, -1});
    for (int i = 0; i < static_cast<int>(seams_.size()); ++i) {
      const FlapWish wish = wish_of(seams_[i]);
      for (const int s : {0, 1}) {
        if (!wish.allowed[s]) continue;
        std::array<bool, 2> shares;
        for (const int end : {0, 1}) {
          const int other = corners_[i][s][end].other.seam;
          const bool is_same = other != -1 && chain_of[other] == chain_of[i];
          shares[end] = is_same && (other != i || wish.both);
        }
        const auto flap = best(i, s, shares);
        heights_[i][s] = flap ? flap->height : 0;
      }
    }
    if (options_.side != FlapSide::kAlternate) {
      const auto first_within = std::ranges::stable_partition(
          chains, [&](const auto& chain) { return !is_within_net(chain.front().seam); });
      const double full = options_.shape.height;
      chosen_ =
          sides_in_chains({chains.begin(), first_within.begin()}, heights_, full, kChangeBetween);
      const std::vector<int> within = sides_in_chains(first_within, heights_, full, kChangeWithin);
      for (int i = 0; i < static_cast<int>(seams_.size()); ++i) {
        if (is_within_net(i)) chosen_[i] = within[i];
      }
      return;
    }
    chosen_ = sides_in_turn(nets_, seams_);
    for (std::size_t i = 0; i < seams_.size(); ++i) {
      int& side = chosen_[i];
      if (heights_[i][1 - side] > heights_[i][side]) side = 1 - side;
    }
  }

  /// Whether both sides are on one piece, which is glued to itself bit by bit.
  bool is_within_net(int seam) const {
    return seams_[seam].sides[0].net == seams_[seam].sides[1].net;
  }

  /// Seams that want flaps, those with least room first and short ones last.
  std::vector<int> by_scarcity() const {
    std::vector<std::tuple<bool, double, int>> order;
    for (int i = 0; i < static_cast<int>(seams_.size()); ++i) {
      const FlapWish wish = wish_of(seams_[i]);
      if (!wish.allowed[0] && !wish.allowed[1]) continue;
      const bool is_short = seams_[i].sides[0].length() <= kWantedLength;
      order.emplace_back(is_short, heights_[i][chosen_[i]], i);
    }
    std::ranges::sort(order);
    std::vector<int> seams;
    for (const auto& entry : order) seams.push_back(std::get<2>(entry));
    return seams;
  }

  /// Whether a flap beside a corner is there, or is still to come.
  bool is_awaited(const SeamStep& step) const {
    if (step.seam == -1) return false;
    if (is_served_[step.seam]) return placed_[step.seam][step.side].has_value();
    const bool is_wanted = chosen_[step.seam] == step.side || wish_of(seams_[step.seam]).both;
    return is_wanted && heights_[step.seam][step.side] > 0;
  }

  void put(int seam, int s, const Trapezoid& shape) {
    placed_[seam][s] = {shape, room_.take(seams_[seam].sides[s], shape)};
  }

  /// The best flap beside those that are there and those that are still to come.
  std::optional<Trapezoid> best_for_now(int seam, int s) {
    if (!wish_of(seams_[seam]).allowed[s]) return std::nullopt;
    const auto& corners = corners_[seam][s];
    return best(seam, s, {is_awaited(corners[0].other), is_awaited(corners[1].other)});
  }

  /// A flap on the side that was decided on; on the other one where it would be lost. Within a net
  /// what was placed meanwhile may decide otherwise.
  void serve(int seam) {
    int& chosen = chosen_[seam];
    auto flap = best_for_now(seam, chosen);
    const bool may_change = options_.side != FlapSide::kAlternate && is_within_net(seam);
    if (!flap || may_change) {
      const auto other = best_for_now(seam, 1 - chosen);
      // A little wider is no reason to change sides.
      if (std::get<0>(rank_of(other)) > std::get<0>(rank_of(flap))) {
        flap = other;
        chosen = 1 - chosen;
      }
    }
    if (!flap) return;
    put(seam, chosen, *flap);
    if (!wish_of(seams_[seam]).both) return;
    // A slit has both sides in one net, so that the first flap may be in the way of the second.
    if (const auto again = best_for_now(seam, 1 - chosen)) put(seam, 1 - chosen, *again);
  }

  /// Once all flaps are there each takes what room is left.
  void serve_again(int seam) {
    const FlapWish wish = wish_of(seams_[seam]);
    const double full = wishes_.shape_at(seams_[seam].mesh_edges).height;
    for (const int s : {chosen_[seam], 1 - chosen_[seam]}) {
      auto& placed = placed_[seam][s];
      if (placed) {
        if (placed->shape.height >= full) continue;
        room_.give_back(seams_[seam].sides[s], placed->taken);
        const auto flap = best(seam, s, {false, false});
        put(seam, s, rank_of(flap) > rank_of(placed->shape) ? *flap : placed->shape);
      } else if (wish.allowed[s] && (wish.both || !placed_[seam][1 - s])) {
        if (const auto flap = best(seam, s, {false, false})) put(seam, s, *flap);
      }
    }
  }

  /// Lays the sides of a seam's flaps on what is cut close beside them, or takes them away from it.
  void set_apart(int seam) {
    for (const int s : {0, 1}) {
      auto& placed = placed_[seam][s];
      if (!placed) continue;
      const SeamSide& side = seams_[seam].sides[s];
      room_.give_back(side, placed->taken);
      put(seam, s, room_.set_apart(site(seam, s), seams_[seam].cover_of(s), placed->shape));
    }
  }

  /// Writes down what came of all seams.
  void finish(std::span<const int> order) {
    plan_.flaps.resize(nets_.size());
    for (const int i : order) {
      const Seam& seam = seams_[i];
      double height = 0;
      for (const int s : {0, 1}) {
        if (!placed_[i][s]) continue;
        height = std::max(height, placed_[i][s]->shape.height);
        write_flap(seam.sides[s], placed_[i][s]->shape, angle_at(seam.mesh_edge()));
      }
      count(i, wish_of(seam), height);
    }
  }

  void serve_borders() {
    for (const SeamSide& side : find_borders(mesh_, nets_, panels_)) {
      std::vector<int> mesh_edges;
      for (const int e : side.edges) mesh_edges.push_back(nets_[side.net].edges[e].mesh_edge);
      const bool stands = options_.side != FlapSide::kNone && is_joint(mesh_edges.front());
      if (!options_.borders && !stands) continue;
      if (!wishes_.allow_border(mesh_edges)) continue;
      const FlapShape shape = wishes_.shape_at(mesh_edges);
      const auto flap = room_.best(room_.site_of(side, shape.height), {}, shape);
      if (!flap) continue;
      room_.take(side, *flap);
      write_flap(side, *flap, angle_at(mesh_edges.front()));
      ++plan_.counts.borders;
    }
  }

  void write_flap(const SeamSide& side, const Trapezoid& shape, double angle) {
    const std::vector<Vec2> corners = flap_corners(side, shape);
    plan_.flaps[side.net].push_back({side.edge(),
                                     side.base,
                                     {corners[0], corners[1], corners[2], corners[3]},
                                     shape.height,
                                     angle});
  }

  bool is_joint(int mesh_edge) const {
    return std::ranges::binary_search(mesh_.joints, mesh_edge, {}, &Joint::edge);
  }

  /// By which the base of a flap at this edge folds.
  double angle_at(int mesh_edge) const {
    if (mesh_.edges[mesh_edge].faces[1] != -1) return fold_angle(mesh_, mesh_edge);
    const auto joint = std::ranges::lower_bound(mesh_.joints, mesh_edge, {}, &Joint::edge);
    if (joint == mesh_.joints.end() || joint->edge != mesh_edge) return 0;
    return angle_onto(joint->edge, joint->host);
  }

  /// By which a flap at a border edge folds until it lies on the first face of its host: valley
  /// positive.
  double angle_onto(int edge, int host) const {
    const Mesh::Edge& foot = mesh_.edges[edge];
    const Vec3& from = mesh_.positions[foot.vertices[0]];
    const Vec3 along = (mesh_.positions[foot.vertices[1]] - from).normalized();
    const auto away = [&](int face) {
      const auto& corners = mesh_.faces[face];
      Vec3 middle = Vec3::Zero();
      for (const int v : corners) middle += mesh_.positions[v] / 3;
      const Vec3 across = middle - from;
      return Vec3((across - along.dot(across) * along).normalized());
    };
    const Vec3 inwards = away(foot.faces[0]);
    const Vec3 onto = away(mesh_.edges[host].faces[0]);
    // The face lies on the left of its edge.
    return std::atan2(onto.dot(along.cross(inwards)), -onto.dot(inwards));
  }

  void count(int index, const FlapWish& wish, double height) {
    const Seam& seam = seams_[index];
    const double length = seam.sides[0].length();
    if (length <= kWantedLength) return;
    FlapCounts& counts = plan_.counts;
    ++counts.wanted;
    counts.wanted_length += length;
    if (height == 0) {
      counts.missing_length += length;
      plan_.missed.push_back({seam.mesh_edge(), why_missed(index, wish)});
    } else {
      ++(height >= wishes_.shape_at(seam.mesh_edges).height ? counts.full : counts.shrunk);
    }
  }

  FlapMiss why_missed(int index, const FlapWish& wish) {
    FlapMiss why = FlapMiss::kShort;
    for (const int s : {0, 1}) {
      if (!wish.allowed[s]) continue;
      const FlapCover cover = seams_[index].cover_of(s);
      why = std::max(why, room_.why_none(site(index, s), cover, shape_of(index, s)));
    }
    return why;
  }

  const Mesh& mesh_;
  std::span<const Net> nets_;
  const FlapOptions& options_;
  std::vector<NetPanels> panels_;  ///< per net
  std::vector<Seam> seams_;
  FlapWishes wishes_;
  FlapRoom room_;
  /// Per seam and side, once a flap was tried there.
  std::vector<std::array<std::optional<FlapRoom::Site>, 2>> sites_;
  std::vector<std::array<std::array<Corner, 2>, 2>> corners_;  ///< per seam, side and end
  std::vector<RunEnds> runs_;                                  ///< per seam
  std::vector<SideHeights> heights_;                           ///< per seam, where flaps may be
  std::vector<int> chosen_;                                    ///< per seam: the side of its flap
  std::vector<char> is_served_;                                ///< per seam
  std::vector<std::array<std::optional<PlacedFlap>, 2>> placed_;  ///< per seam and side
  FlapPlan plan_;
};

}  // namespace

FlapPlan place_flaps(const Mesh& mesh, std::span<const Net> nets, const FlapOptions& options,
                     std::span<const std::vector<std::vector<Vec2>>> keep_off) {
  return FlapPlacer(mesh, nets, options, keep_off).place();
}

}  // namespace foldwright
