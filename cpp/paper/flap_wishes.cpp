#include "paper/flap_wishes.h"

#include <algorithm>

#include "mesh/input_error.h"

namespace foldwright {
namespace {

/// The same flaps seen along the edge the other way.
EdgeFlaps seen_from_behind(EdgeFlaps flaps) {
  if (flaps == EdgeFlaps::kLeft) return EdgeFlaps::kRight;
  if (flaps == EdgeFlaps::kRight) return EdgeFlaps::kLeft;
  return flaps;
}

/// The face of the mesh beside an edge of the mesh on a side of its seam.
int face_at(const SeamSide& side, const Net& net, int mesh_edge) {
  const auto edge =
      std::ranges::find(side.edges, mesh_edge, [&](int e) { return net.edges[e].mesh_edge; });
  return net.faces[side.faces[edge - side.edges.begin()]];
}

}  // namespace

FlapWishes::FlapWishes(const Mesh& mesh, const FlapOptions& options)
    : mesh_(mesh), options_(options) {
  if (options.choices.empty()) return;
  std::map<std::array<int, 2>, int> edges;
  for (int e = 0; e < mesh.edge_count(); ++e) edges[mesh.edges[e].vertices] = e;
  int order = 0;
  for (const auto& [from, to, flaps, height] : options.choices) {
    const auto ahead = edges.find({from, to});
    const auto back = edges.find({to, from});
    if (ahead != edges.end()) {
      choices_[ahead->second] = {flaps, height, order++};
    } else if (back != edges.end()) {
      choices_[back->second] = {seen_from_behind(flaps), height, order++};
    } else {
      throw InputError("bad-option", {{"what", "flap-edge"}, {"from", from}, {"to", to}});
    }
  }
}

FlapWish FlapWishes::of(const Seam& seam, std::span<const Net> nets) const {
  const auto* choice = choice_at(seam.mesh_edges);
  if (!choice || choice->second.flaps == EdgeFlaps::kUsual) {
    const bool any = options_.side != FlapSide::kNone;
    return {{any, any}, options_.side == FlapSide::kBoth};
  }
  const auto& [edge, chosen] = *choice;
  FlapWish wish = {{}, chosen.flaps == EdgeFlaps::kBoth};
  for (const int s : {0, 1}) {
    const SeamSide& side = seam.sides[s];
    const bool is_left = face_at(side, nets[side.net], edge) == mesh_.edges[edge].faces[0];
    wish.allowed[s] = wish.both || chosen.flaps == (is_left ? EdgeFlaps::kLeft : EdgeFlaps::kRight);
  }
  return wish;
}

bool FlapWishes::allow_border(std::span<const int> mesh_edges) const {
  const auto* choice = choice_at(mesh_edges);
  if (!choice) return true;
  // A border has its only face on the left.
  const EdgeFlaps flaps = choice->second.flaps;
  return flaps != EdgeFlaps::kNone && flaps != EdgeFlaps::kRight;
}

FlapShape FlapWishes::shape_at(std::span<const int> mesh_edges) const {
  FlapShape shape = options_.shape;
  const auto* choice = choice_at(mesh_edges);
  if (choice && choice->second.height > 0) {
    shape.height = choice->second.height;
    shape.least = std::min(shape.least, shape.height);
  }
  return shape;
}

auto FlapWishes::choice_at(std::span<const int> mesh_edges) const
    -> const std::pair<const int, EdgeChoice>* {
  const std::pair<const int, EdgeChoice>* latest = nullptr;
  if (choices_.empty()) return latest;
  for (const int e : mesh_edges) {
    const auto choice = choices_.find(e);
    if (choice == choices_.end()) continue;
    if (!latest || choice->second.order > latest->second.order) latest = &*choice;
  }
  return latest;
}

}  // namespace foldwright
