#include "paper/seams.h"

#include <algorithm>
#include <map>
#include <set>
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

/// Calls `visit` with a side of every edge that `wants` takes; of a cut with both.
template <class Wants, class Visit>
void for_sides(std::span<const Net> nets, Wants&& wants, Visit&& visit) {
  for (int n = 0; n < static_cast<int>(nets.size()); ++n) {
    const Net& net = nets[n];
    const auto faces = directed_edges(net);
    for (int e = 0; e < static_cast<int>(net.edges.size()); ++e) {
      const NetEdge& edge = net.edges[e];
      if (!wants(edge)) continue;
      const auto& [from, to] = edge.vertices;
      const auto [face, corner] = faces.at({from, to});
      const int third = net.corners[face][(corner + 2) % 3];
      visit(SeamSide{n, e, face, net.vertices[from], net.vertices[to], net.vertices[third]});
    }
  }
}

bool is_cut(const NetEdge& edge) { return edge.assignment == Assignment::kCut; }

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
  for_sides(nets, is_cut, [&](const SeamSide& side) {
    sides[nets[side.net].edges[side.edge].mesh_edge].push_back(side);
  });
  std::vector<Seam> seams;
  for (auto& [edge, both] : sides) {
    if (both.size() == 2) seams.push_back({edge, {both[0], both[1]}});
  }
  return seams;
}

std::vector<Seam> find_joint_seams(const Mesh& mesh, std::span<const Net> nets) {
  if (mesh.joints.empty()) return {};
  std::map<int, SeamSide> sides;  // by mesh edge; of a cut the first one
  std::set<int> wanted;
  for (const auto& [edge, host] : mesh.joints) wanted.insert({edge, host});
  for_sides(
      nets, [&](const NetEdge& edge) { return wanted.contains(edge.mesh_edge); },
      [&](const SeamSide& side) {
        sides.emplace(nets[side.net].edges[side.edge].mesh_edge, side);
      });
  std::vector<Seam> joints;
  for (const auto& [edge, host] : mesh.joints) {
    const auto stands = sides.find(edge);
    const auto on = sides.find(host);
    if (stands == sides.end() || on == sides.end()) continue;
    joints.push_back({edge, {stands->second, on->second}});
  }
  return joints;
}

std::vector<SeamSide> find_borders(const Mesh& mesh, std::span<const Net> nets) {
  std::vector<SeamSide> borders;
  for_sides(nets, is_cut, [&](const SeamSide& side) {
    const int edge = nets[side.net].edges[side.edge].mesh_edge;
    if (mesh.edges[edge].faces[1] == -1) borders.push_back(side);
  });
  return borders;
}

}  // namespace foldwright
