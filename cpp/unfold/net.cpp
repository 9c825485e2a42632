#include "unfold/net.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "geometry/union_find.h"

namespace foldwright {
namespace {

int corner_at(const Mesh& mesh, int face, int vertex) {
  const auto& corners = mesh.faces[face];
  return static_cast<int>(std::find(corners.begin(), corners.end(), vertex) - corners.begin());
}

/// What a net's edges are: per mesh edge, whether the net folds there or lies in one panel.
std::vector<char> joined_edges(const Mesh& mesh, const DualGraph& graph,
                               std::span<const int> folds) {
  std::vector<char> joined(mesh.edges.size(), 0);
  for (const int h : folds) {
    for (const int e : graph.hinges[h].edges) joined[e] = 1;
  }
  std::vector<int> panel_of(mesh.faces.size(), -1);
  for (int panel = 0; panel < graph.panel_count(); ++panel) {
    for (const int face : graph.panel_faces(panel)) panel_of[face] = panel;
  }
  for (const int face : graph.faces) {
    for (const int e : mesh.face_edges[face]) {
      const auto& [f, g] = mesh.edges[e].faces;
      if (g != -1 && panel_of[f] == panel_of[g]) joined[e] = 1;
    }
  }
  return joined;
}

Assignment fold_assignment(double angle) {
  if (std::abs(angle) < kPanelAngle) return Assignment::kFlat;
  return angle < 0 ? Assignment::kMountain : Assignment::kValley;
}

/// Corners merged across joined edges become the net's vertices.
void add_vertices(const Mesh& mesh, Net& net, std::span<const char> joined,
                  std::span<const int> slot_of, std::span<const Triangle2> placed) {
  const int n = static_cast<int>(net.faces.size());
  UnionFind corners(3 * n);
  for (int slot = 0; slot < n; ++slot) {
    for (const int e : mesh.face_edges[net.faces[slot]]) {
      if (!joined[e]) continue;
      const auto& [f, g] = mesh.edges[e].faces;
      for (const int v : mesh.edges[e].vertices) {
        corners.join(3 * slot_of[f] + corner_at(mesh, f, v),
                     3 * slot_of[g] + corner_at(mesh, g, v));
      }
    }
  }
  std::vector<int> vertex_of(3 * n, -1);
  for (int slot = 0; slot < n; ++slot) {
    for (int i = 0; i < 3; ++i) {
      int& vertex = vertex_of[corners.find(3 * slot + i)];
      if (vertex == -1) {
        vertex = static_cast<int>(net.vertices.size());
        net.vertices.push_back(placed[slot][i]);
      }
      net.corners[slot][i] = vertex;
    }
  }
}

void add_edges(const Mesh& mesh, Net& net, std::span<const char> joined) {
  for (std::size_t slot = 0; slot < net.faces.size(); ++slot) {
    const int face = net.faces[slot];
    for (int i = 0; i < 3; ++i) {
      const int e = mesh.face_edges[face][i];
      const std::array<int, 2> ends = {net.corners[slot][i], net.corners[slot][(i + 1) % 3]};
      if (!joined[e]) {
        net.edges.push_back({ends, e, Assignment::kCut, 0});
      } else if (mesh.edges[e].faces[0] == face) {
        const double angle = fold_angle(mesh, e);
        net.edges.push_back({ends, e, fold_assignment(angle), angle});
      }
    }
  }
}

double longest_edge(const Triangle2& t) {
  return std::max({(t[1] - t[0]).norm(), (t[2] - t[1]).norm(), (t[0] - t[2]).norm()});
}

std::vector<Triangle2> net_triangles(const Net& net) {
  std::vector<Triangle2> triangles;
  for (const auto& [a, b, c] : net.corners) {
    triangles.push_back({net.vertices[a], net.vertices[b], net.vertices[c]});
  }
  return triangles;
}

/// Pairs that share area, found by a sweep over x.
int count_overlaps(std::span<const Triangle2> triangles, double unit) {
  std::vector<Box2> boxes;
  for (const Triangle2& triangle : triangles) boxes.push_back(box_of(triangle));
  std::vector<int> by_left(triangles.size());
  std::iota(by_left.begin(), by_left.end(), 0);
  std::sort(by_left.begin(), by_left.end(), [&](int a, int b) {
    return boxes[a].min[0] != boxes[b].min[0] ? boxes[a].min[0] < boxes[b].min[0] : a < b;
  });
  int overlaps = 0;
  for (std::size_t i = 0; i < by_left.size(); ++i) {
    const int a = by_left[i];
    for (std::size_t j = i + 1; j < by_left.size(); ++j) {
      const int b = by_left[j];
      if (boxes[b].min[0] >= boxes[a].max[0]) break;
      if (!boxes[a].meets(boxes[b])) continue;
      // A strip as deep as the layout's tolerance along the longer of the two.
      const double reach = std::max(longest_edge(triangles[a]), longest_edge(triangles[b]));
      if (intersection_area(triangles[a], triangles[b]) > kOverlapTolerance * unit * reach) {
        ++overlaps;
      }
    }
  }
  return overlaps;
}

int count_unconnected(const Net& net) {
  // Faces that share both ends of an edge are joined there: cuts never share a vertex pair.
  UnionFind faces(static_cast<int>(net.faces.size()));
  std::vector<std::array<int, 3>> sides;  // low vertex, high vertex, face
  for (int f = 0; f < static_cast<int>(net.faces.size()); ++f) {
    for (int i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax(net.corners[f][i], net.corners[f][(i + 1) % 3]);
      sides.push_back({low, high, f});
    }
  }
  std::sort(sides.begin(), sides.end());
  for (std::size_t i = 1; i < sides.size(); ++i) {
    if (sides[i][0] == sides[i - 1][0] && sides[i][1] == sides[i - 1][1]) {
      faces.join(sides[i][2], sides[i - 1][2]);
    }
  }
  int unconnected = 0;
  for (int f = 0; f < static_cast<int>(net.faces.size()); ++f) unconnected += faces.find(f) != 0;
  return unconnected;
}

}  // namespace

Net make_net(const Mesh& mesh, const DualGraph& graph, std::span<const int> folds) {
  Net net;
  net.faces = graph.faces;
  std::sort(net.faces.begin(), net.faces.end());
  net.corners.resize(net.faces.size());
  std::vector<int> slot_of(mesh.faces.size(), -1);
  for (std::size_t slot = 0; slot < net.faces.size(); ++slot) {
    slot_of[net.faces[slot]] = static_cast<int>(slot);
  }
  const Layout layout = lay_out(graph, hang_tree(graph, folds));
  std::vector<Triangle2> placed(net.faces.size());
  for (int panel = 0; panel < graph.panel_count(); ++panel) {
    for (int i = graph.first_face[panel]; i < graph.first_face[panel + 1]; ++i) {
      placed[slot_of[graph.faces[i]]] = moved(layout[panel], graph.triangles[i]);
    }
  }
  const std::vector<char> joined = joined_edges(mesh, graph, folds);
  add_vertices(mesh, net, joined, slot_of, placed);
  add_edges(mesh, net, joined);
  return net;
}

NetCheck check_net(const Mesh& mesh, const Net& net) {
  NetCheck check;
  const std::vector<Triangle2> triangles = net_triangles(net);
  check.overlaps = count_overlaps(triangles, mean_edge_length(mesh));
  check.unconnected = count_unconnected(net);
  for (std::size_t slot = 0; slot < triangles.size(); ++slot) {
    const Triangle2& flat = triangles[slot];
    const double longest = longest_edge(flat);
    if (cross(flat[1] - flat[0], flat[2] - flat[0]) <= 0) ++check.mirrored;
    for (int i = 0; i < 3; ++i) {
      const auto& corners = mesh.faces[net.faces[slot]];
      const double solid =
          (mesh.positions[corners[(i + 1) % 3]] - mesh.positions[corners[i]]).norm();
      const double error = std::abs((flat[(i + 1) % 3] - flat[i]).norm() - solid) / longest;
      check.length_error = std::max(check.length_error, error);
    }
  }
  return check;
}

}  // namespace foldwright
