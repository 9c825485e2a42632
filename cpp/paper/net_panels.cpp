#include "paper/net_panels.h"

#include <map>
#include <utility>

#include "geometry/union_find.h"

namespace foldwright {

NetPanels::NetPanels(const Net& net) : face_of_edge_(net.edges.size(), -1) {
  const int count = static_cast<int>(net.corners.size());
  std::map<std::pair<int, int>, int> face_from;  // by directed edge
  for (int face = 0; face < count; ++face) {
    const auto& corners = net.corners[face];
    for (int i = 0; i < 3; ++i) face_from[{corners[i], corners[(i + 1) % 3]}] = face;
  }
  const auto face_left_of = [&](int from, int to) {
    const auto found = face_from.find({from, to});
    return found == face_from.end() ? -1 : found->second;
  };
  UnionFind joined(count);
  for (std::size_t e = 0; e < net.edges.size(); ++e) {
    const auto& [from, to] = net.edges[e].vertices;
    face_of_edge_[e] = face_left_of(from, to);
    const int other = face_left_of(to, from);
    const bool is_inner = net.edges[e].assignment == Assignment::kFlat && other != -1;
    if (is_inner) joined.join(face_of_edge_[e], other);
  }
  std::vector<int> number(count, -1);
  for (int face = 0; face < count; ++face) {
    int& panel = number[joined.find(face)];
    if (panel == -1) {
      panel = panel_count();
      borders_.emplace_back();
    }
    panel_of_.push_back(panel);
  }
  for (int face = 0; face < count; ++face) {
    const auto& corners = net.corners[face];
    for (int i = 0; i < 3; ++i) {
      const int from = corners[i];
      const int to = corners[(i + 1) % 3];
      const int other = face_left_of(to, from);
      if (other != -1 && panel_of_[other] == panel_of_[face]) continue;
      borders_[panel_of_[face]].push_back({from, to});
    }
  }
}

std::vector<NetPanels> panels_of(std::span<const Net> nets) {
  std::vector<NetPanels> panels;
  for (const Net& net : nets) panels.emplace_back(net);
  return panels;
}

}  // namespace foldwright
