#include "paper/flaps.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <tuple>

#include "mesh/input_error.h"
#include "paper/outline.h"
#include "paper/seams.h"

namespace foldwright {
namespace {

/// A side of a seam, by its index; -1: none.
using SideIndex = int;

std::tuple<double, double> rank_of(const std::optional<Trapezoid>& flap) {
  if (!flap) return {0, 0};
  return {flap->height, flap->top[1] - flap->top[0]};
}

/// The same flaps seen along the edge the other way.
EdgeFlaps from_behind(EdgeFlaps flaps) {
  if (flaps == EdgeFlaps::kLeft) return EdgeFlaps::kRight;
  if (flaps == EdgeFlaps::kRight) return EdgeFlaps::kLeft;
  return flaps;
}

/// What a person decided about an edge, seen along it as the mesh has it.
struct EdgeChoice {
  EdgeFlaps flaps;
  double height;  ///< mm; 0: as all others
};

/// The choices, by mesh edge.
std::map<int, EdgeChoice> choices_by_edge(const Mesh& mesh, std::span<const FlapChoice> choices) {
  std::map<int, EdgeChoice> chosen;
  if (choices.empty()) return chosen;
  std::map<std::array<int, 2>, int> edges;
  for (int e = 0; e < mesh.edge_count(); ++e) edges[mesh.edges[e].vertices] = e;
  for (const auto& [from, to, flaps, height] : choices) {
    const auto ahead = edges.find({from, to});
    const auto back = edges.find({to, from});
    if (ahead != edges.end()) {
      chosen[ahead->second] = {flaps, height};
    } else if (back != edges.end()) {
      chosen[back->second] = {from_behind(flaps), height};
    } else {
      throw InputError("bad-option", {{"what", "flap-edge"}, {"from", from}, {"to", to}});
    }
  }
  return chosen;
}

/// Per seam the side on which a flap is preferred: along each outline on every other edge that has
/// no preference yet.
std::vector<SideIndex> preferred_in_turn(std::span<const Net> nets, std::span<const Seam> seams) {
  std::vector<std::vector<std::pair<int, int>>> seam_of(nets.size());  // seam, side; by edge
  for (std::size_t n = 0; n < nets.size(); ++n) seam_of[n].resize(nets[n].edges.size(), {-1, 0});
  for (int i = 0; i < static_cast<int>(seams.size()); ++i) {
    for (const int s : {0, 1}) {
      const SeamSide& side = seams[i].sides[s];
      seam_of[side.net][side.edge] = {i, s};
    }
  }
  std::vector<SideIndex> preferred(seams.size(), -1);
  for (std::size_t n = 0; n < nets.size(); ++n) {
    std::vector<int> edge_from(nets[n].vertices.size(), -1);
    for (std::size_t e = 0; e < nets[n].edges.size(); ++e) {
      if (seam_of[n][e].first != -1) edge_from[nets[n].edges[e].vertices[0]] = static_cast<int>(e);
    }
    bool here = true;
    for (const std::vector<int>& walk : boundary_walks(nets[n])) {
      for (const int vertex : walk) {
        if (edge_from[vertex] == -1) continue;
        const auto [seam, side] = seam_of[n][edge_from[vertex]];
        // An edge that another piece decided about sets the turn, too.
        if (preferred[seam] == -1) preferred[seam] = here ? side : 1 - side;
        here = preferred[seam] != side;
      }
    }
  }
  return preferred;
}

class FlapPlacer {
 public:
  FlapPlacer(const Mesh& mesh, std::span<const Net> nets, const FlapOptions& options,
             std::span<const std::vector<std::vector<Vec2>>> keep_off)
      : mesh_(mesh),
        nets_(nets),
        options_(options),
        seams_(find_seams(nets)),
        choices_(choices_by_edge(mesh, options.choices)),
        room_(nets, keep_off),
        preferred_(seams_.size(), -1) {
    if (options.side == FlapSide::kAlternate) preferred_ = preferred_in_turn(nets, seams_);
    plan_.flaps.resize(nets.size());
  }

  FlapPlan place() {
    for (const int i : by_scarcity()) serve(i);
    if (options_.borders || !mesh_.joints.empty()) serve_borders();
    for (auto& flaps : plan_.flaps) {
      std::ranges::sort(flaps, {}, [](const Flap& flap) { return flap.edge; });
    }
    std::ranges::sort(plan_.missed, {}, [](const MissedFlap& miss) { return miss.mesh_edge; });
    return std::move(plan_);
  }

 private:
  /// Which of a seam's sides may have flaps, and whether all of them are to.
  struct Wish {
    std::array<bool, 2> allowed;
    bool both;
  };

  /// What a person chose for an edge.
  EdgeFlaps flaps_at(int mesh_edge) const {
    const auto chosen = choices_.find(mesh_edge);
    return chosen == choices_.end() ? EdgeFlaps::kUsual : chosen->second.flaps;
  }

  /// How flaps at an edge may look.
  FlapShape shape_at(int mesh_edge) const {
    FlapShape shape = options_.shape;
    const auto chosen = choices_.find(mesh_edge);
    if (chosen != choices_.end() && chosen->second.height > 0) {
      shape.height = chosen->second.height;
      shape.least = std::min(shape.least, shape.height);
    }
    return shape;
  }

  Wish wish_of(const Seam& seam) const {
    const EdgeFlaps flaps = flaps_at(seam.mesh_edge);
    if (flaps == EdgeFlaps::kUsual) {
      const bool any = options_.side != FlapSide::kNone;
      return {{any, any}, options_.side == FlapSide::kBoth};
    }
    Wish wish = {{}, flaps == EdgeFlaps::kBoth};
    for (const int s : {0, 1}) {
      const SeamSide& side = seam.sides[s];
      // The face on the left of a mesh edge is its first.
      const bool is_left = nets_[side.net].faces[side.face] == mesh_.edges[seam.mesh_edge].faces[0];
      wish.allowed[s] = wish.both || flaps == (is_left ? EdgeFlaps::kLeft : EdgeFlaps::kRight);
    }
    return wish;
  }

  std::optional<Trapezoid> best(const Seam& seam, int s) const {
    return room_.best(seam.sides[s], apex_beyond(seam.sides[s], seam.sides[1 - s]),
                      shape_at(seam.mesh_edge));
  }

  /// Seams that want flaps, those with least room first and short edges last.
  std::vector<int> by_scarcity() const {
    std::vector<std::tuple<bool, double, double, int>> order;
    for (int i = 0; i < static_cast<int>(seams_.size()); ++i) {
      const Wish wish = wish_of(seams_[i]);
      if (!wish.allowed[0] && !wish.allowed[1]) continue;
      std::tuple<double, double> most = {0, 0};
      for (const int s : {0, 1}) {
        if (wish.allowed[s]) most = std::max(most, rank_of(best(seams_[i], s)));
      }
      const bool is_short = seams_[i].sides[0].length() <= kWantedLength;
      order.emplace_back(is_short, std::get<0>(most), std::get<1>(most), i);
    }
    std::ranges::sort(order);
    std::vector<int> seams;
    for (const auto& entry : order) seams.push_back(std::get<3>(entry));
    return seams;
  }

  void serve(int index) {
    const Seam& seam = seams_[index];
    const SideIndex preferred = preferred_[index];
    const Wish wish = wish_of(seam);
    std::array<std::optional<Trapezoid>, 2> found;
    for (const int s : {0, 1}) {
      if (wish.allowed[s]) found[s] = best(seam, s);
    }
    const auto height = [&](int s) { return std::get<0>(rank_of(found[s])); };
    int chosen = rank_of(found[1]) > rank_of(found[0]) ? 1 : 0;
    if (preferred != -1 && found[preferred] && height(preferred) >= height(1 - preferred)) {
      chosen = preferred;
    }
    count(seam, wish, std::max(height(0), height(1)));
    if (found[chosen]) add_flap(seam.mesh_edge, seam.sides[chosen], *found[chosen]);
    if (!wish.both) return;
    // A slit has both sides in one net, so that the first flap may be in the way of the second.
    const auto again = best(seam, 1 - chosen);
    if (again) add_flap(seam.mesh_edge, seam.sides[1 - chosen], *again);
  }

  void serve_borders() {
    for (const SeamSide& side : find_borders(mesh_, nets_)) {
      const int edge = nets_[side.net].edges[side.edge].mesh_edge;
      const bool stands = options_.side != FlapSide::kNone && is_joint(edge);
      if (!options_.borders && !stands) continue;
      const EdgeFlaps flaps = flaps_at(edge);
      // A border has its only face on the left.
      if (flaps == EdgeFlaps::kNone || flaps == EdgeFlaps::kRight) continue;
      const auto flap = room_.best(side, open_apex(side), shape_at(edge));
      if (!flap) continue;
      add_flap(edge, side, *flap);
      ++plan_.counts.borders;
    }
  }

  void add_flap(int mesh_edge, const SeamSide& side, const Trapezoid& shape) {
    const std::vector<Vec2> corners = flap_corners(side, shape);
    plan_.flaps[side.net].push_back({side.edge,
                                     {corners[0], corners[1], corners[2], corners[3]},
                                     shape.height,
                                     angle_at(mesh_edge)});
    room_.take(side, shape);
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

  void count(const Seam& seam, const Wish& wish, double height) {
    const double length = seam.sides[0].length();
    if (length <= kWantedLength) return;
    FlapCounts& counts = plan_.counts;
    ++counts.wanted;
    counts.wanted_length += length;
    if (height == 0) {
      counts.missing_length += length;
      plan_.missed.push_back({seam.mesh_edge, why_missed(seam, wish)});
    } else {
      ++(height >= shape_at(seam.mesh_edge).height ? counts.full : counts.shrunk);
    }
  }

  FlapMiss why_missed(const Seam& seam, const Wish& wish) const {
    FlapMiss why = FlapMiss::kShort;
    for (const int s : {0, 1}) {
      if (!wish.allowed[s]) continue;
      const Vec2 apex = apex_beyond(seam.sides[s], seam.sides[1 - s]);
      why = std::max(why, room_.why_none(seam.sides[s], apex, shape_at(seam.mesh_edge)));
    }
    return why;
  }

  const Mesh& mesh_;
  std::span<const Net> nets_;
  const FlapOptions& options_;
  std::vector<Seam> seams_;
  std::map<int, EdgeChoice> choices_;
  FlapRoom room_;
  std::vector<SideIndex> preferred_;  ///< per seam, for alternating flaps
  FlapPlan plan_;
};

}  // namespace

FlapPlan place_flaps(const Mesh& mesh, std::span<const Net> nets, const FlapOptions& options,
                     std::span<const std::vector<std::vector<Vec2>>> keep_off) {
  return FlapPlacer(mesh, nets, options, keep_off).place();
}

}  // namespace foldwright
