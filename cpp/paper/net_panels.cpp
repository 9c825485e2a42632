#include "paper/net_panels.h"

#include <array>

#include "geometry/union_find.h"

namespace foldwright {
namespace {

/// The faces of a net by the edges that they lie on the left of.
class FacesByEdge {
 public:
  explicit FacesByEdge(const Net& net) : starts_(net.vertices.size() + 1, 0) {
    for (const std::array<int, 3>& corners : net.corners) {
      for (const int corner : corners) ++starts_[corner + 1];
    }
    for (std::size_t v = 1; v < starts_.size(); ++v) starts_[v] += starts_[v - 1];
    out_.resize(starts_.back());
    std::vector<int> next(starts_.begin(), starts_.end() - 1);
    for (int face = 0; face < static_cast<int>(net.corners.size()); ++face) {
      const auto& corners = net.corners[face];
      for (int i = 0; i < 3; ++i) out_[next[corners[i]]++] = {corners[(i + 1) % 3], face};
    }
  }

  /// -1 if there is none.
  int left_of(int from, int to) const {
    for (int i = starts_[from]; i < starts_[from + 1]; ++i) {
      if (out_[i].to == to) return out_[i].face;
    }
    return -1;
  }

 private:
  struct Out {
    int to, face;
  };
  std::vector<int> starts_;  ///< per vertex: the first of the edges that leave it
  std::vector<Out> out_;
};

}  // namespace

NetPanels::NetPanels(const Net& net) : face_of_edge_(net.edges.size(), -1) {
  const int count = static_cast<int>(net.corners.size());
  const FacesByEdge faces(net);
  UnionFind joined(count);
  for (std::size_t e = 0; e < net.edges.size(); ++e) {
    const auto& [from, to] = net.edges[e].vertices;
    face_of_edge_[e] = faces.left_of(from, to);
    const int other = faces.left_of(to, from);
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
      const int other = faces.left_of(to, from);
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
