#include "paper/seams.h"

#include <algorithm>
#include <map>
#include <utility>

namespace foldwright {
namespace {

/// Per directed edge of a net's faces: the face and the corner it starts from.
std::map<std::pair<int, int>, std::pair<int, int>> directed_edges(const Net& net) {
  std::map<std::pair<int, int>, std::pair<int, int>> edges;
  for (int face = 0; face < static_cast<int>(net.corners.size()); ++face) {
    const auto& corners = net.corners[face];
    for (int i = 0; i < 3; ++i) edges[{corners[i], corners[(i + 1) % 3]}] = {face, i};
  }
  return edges;
}

/// Calls `visit` with every side of a cut.
template <class Visit>
void for_cuts(std::span<const Net> nets, Visit&& visit) {
  for (int n = 0; n < static_cast<int>(nets.size()); ++n) {
    const Net& net = nets[n];
    const auto faces = directed_edges(net);
    for (int e = 0; e < static_cast<int>(net.edges.size()); ++e) {
      const NetEdge& edge = net.edges[e];
      if (edge.assignment != Assignment::kCut) continue;
      const auto& [from, to] = edge.vertices;
      const auto [face, corner] = faces.at({from, to});
      const int third = net.corners[face][(corner + 2) % 3];
      visit(SeamSide{n, e, face, net.vertices[from], net.vertices[to], net.vertices[third]});
    }
  }
}

}  // namespace

Vec2 SeamSide::local(const Vec2& p) const {
  const Vec2 along = (to - from) / length();
  return {along.dot(p - from), cross(p - from, along)};
}

Vec2 SeamSide::global(const Vec2& p) const {
  const Vec2 along = (to - from) / length();
  return from + p.x() * along + p.y() * Vec2(along.y(), -along.x());
}

std::vector<Seam> find_seams(std::span<const Net> nets) {
  std::map<int, std::vector<SeamSide>> sides;  // by mesh edge
  for_cuts(nets, [&](const SeamSide& side) {
    sides[nets[side.net].edges[side.edge].mesh_edge].push_back(side);
  });
  std::vector<Seam> seams;
  for (auto& [edge, both] : sides) {
    if (both.size() == 2) seams.push_back({edge, {both[0], both[1]}});
  }
  return seams;
}

std::vector<SeamSide> find_borders(const Mesh& mesh, std::span<const Net> nets) {
  std::vector<SeamSide> borders;
  for_cuts(nets, [&](const SeamSide& side) {
    const int edge = nets[side.net].edges[side.edge].mesh_edge;
    if (mesh.edges[edge].faces[1] == -1) borders.push_back(side);
  });
  return borders;
}

}  // namespace foldwright
