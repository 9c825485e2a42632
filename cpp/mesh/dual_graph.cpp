#include "mesh/dual_graph.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "geometry/box_pairs.h"

namespace foldwright {
namespace {

// Corners as near to a panel's plane as this, in mean edges, are in it: their lengths change by
// half the square of it.
constexpr double kInPlane = 1e-9;

Vec3 unit_normal(const Mesh& mesh, int face) {
  const auto& [a, b, c] = mesh.faces[face];
  return (mesh.positions[b] - mesh.positions[a])
      .cross(mesh.positions[c] - mesh.positions[a])
      .normalized();
}

double angle_between(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// Orthonormal coordinates of the plane of a panel.
struct Frame {
  Vec3 origin, x, y;

  Vec2 operator()(const Vec3& p) const { return {x.dot(p - origin), y.dot(p - origin)}; }
};

/// Frame on the first face's first edge, turned into the plane of the area-weighted normal.
Frame panel_frame(const Mesh& mesh, std::span<const int> faces) {
  Vec3 normal = Vec3::Zero();
  for (const int face : faces) normal += face_area(mesh, face) * unit_normal(mesh, face);
  normal.normalize();
  const auto& first = mesh.faces[faces[0]];
  const Vec3 along = mesh.positions[first[1]] - mesh.positions[first[0]];
  const Vec3 x = (along - normal.dot(along) * normal).normalized();
  return {mesh.positions[first[0]], x, normal.cross(x)};
}

std::vector<Triangle2> flatten(const Mesh& mesh, std::span<const int> faces) {
  const Frame frame = panel_frame(mesh, faces);
  std::vector<Triangle2> flat;
  for (const int face : faces) {
    const auto& [a, b, c] = mesh.faces[face];
    flat.push_back({frame(mesh.positions[a]), frame(mesh.positions[b]), frame(mesh.positions[c])});
  }
  return flat;
}

/// Whether faces that share a plane lie on each other, as badly made input may have them.
bool overlaps_itself(std::span<const Triangle2> triangles, double unit) {
  std::vector<Box2> boxes;
  for (const Triangle2& triangle : triangles) boxes.push_back(box_of(triangle));
  for (const auto& [i, j] : meeting_boxes(boxes)) {
    if (triangles_overlap(triangles[i], triangles[j], 1e-6 * unit)) return true;
  }
  return false;
}

/// Whether a face lies in the plane of a panel's largest one, and looks the same way.
bool lies_in_plane(const Mesh& mesh, int face, int largest, const Vec3& normal, double unit) {
  const auto& corners = mesh.faces[face];
  const Vec3& origin = mesh.positions[mesh.faces[largest][0]];
  return normal.dot(unit_normal(mesh, face)) > 0 &&
         std::all_of(corners.begin(), corners.end(), [&](int v) {
           return std::abs(normal.dot(mesh.positions[v] - origin)) <= kInPlane * unit;
         });
}

/// Faces of the panel that grows from `seed` over edges that are flat, ascending.
std::vector<int> grow_panel(const Mesh& mesh, int seed, std::vector<char>& taken, double unit) {
  const Vec3 normal = unit_normal(mesh, seed);
  const auto belongs = [&](int e, int face) {
    const bool flat = std::abs(fold_angle(mesh, e)) < kPanelAngle &&
                      angle_between(normal, unit_normal(mesh, face)) <= kPanelDrift;
    return flat || lies_in_plane(mesh, face, seed, normal, unit);
  };
  std::vector<int> faces = {seed};
  taken[seed] = true;
  for (std::size_t head = 0; head < faces.size(); ++head) {
    for (const int e : mesh.face_edges[faces[head]]) {
      const Mesh::Edge& edge = mesh.edges[e];
      const int next = edge.faces[0] == faces[head] ? edge.faces[1] : edge.faces[0];
      if (next == -1 || taken[next] || !belongs(e, next)) continue;
      taken[next] = true;
      faces.push_back(next);
    }
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

/// All panels, each with its faces ascending, in order of their lowest face.
std::vector<std::vector<int>> grow_panels(const Mesh& mesh, double unit) {
  std::vector<double> areas;
  for (int f = 0; f < mesh.face_count(); ++f) areas.push_back(face_area(mesh, f));
  std::vector<int> by_area(areas.size());
  std::iota(by_area.begin(), by_area.end(), 0);
  std::stable_sort(by_area.begin(), by_area.end(),
                   [&](int a, int b) { return areas[a] > areas[b]; });
  std::vector<char> taken(areas.size(), false);
  std::vector<std::vector<int>> panels;
  for (const int seed : by_area) {
    if (!taken[seed]) panels.push_back(grow_panel(mesh, seed, taken, unit));
  }
  std::sort(panels.begin(), panels.end());
  return panels;
}

void add_panel(const Mesh& mesh, DualGraph& graph, std::span<const int> faces,
               std::span<const Triangle2> flat, std::vector<int>& panel_of) {
  double area = 0;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    panel_of[faces[i]] = graph.panel_count();
    area += face_area(mesh, faces[i]);
  }
  graph.faces.insert(graph.faces.end(), faces.begin(), faces.end());
  graph.triangles.insert(graph.triangles.end(), flat.begin(), flat.end());
  graph.areas.push_back(area);
  graph.first_face.push_back(static_cast<int>(graph.faces.size()));
}

std::vector<int> build_panels(const Mesh& mesh, DualGraph& graph) {
  std::vector<int> panel_of(mesh.faces.size(), -1);
  for (const std::vector<int>& faces : grow_panels(mesh, graph.unit)) {
    const std::vector<Triangle2> flat = flatten(mesh, faces);
    if (faces.size() == 1 || !overlaps_itself(flat, graph.unit)) {
      add_panel(mesh, graph, faces, flat, panel_of);
      continue;
    }
    // Not a plane region after all: each face stands alone, joined by flat hinges.
    for (const int face : faces) {
      add_panel(mesh, graph, std::span(&face, 1), flatten(mesh, std::span(&face, 1)), panel_of);
    }
  }
  return panel_of;
}

/// Flat coordinates of an end of a mesh edge in the panel of one of its faces.
Vec2 flat_corner(const Mesh& mesh, const Triangle2& triangle, int face, int vertex) {
  for (int i = 0; i < 3; ++i) {
    if (mesh.faces[face][i] == vertex) return triangle[i];
  }
  assert(false && "vertex is not a corner of the face");
  return triangle[0];
}

Hinge make_hinge(const Mesh& mesh, const DualGraph& graph, int e, std::array<int, 2> panels,
                 std::span<const int> slot_of_face) {
  const Mesh::Edge& edge = mesh.edges[e];
  std::array<int, 2> faces = edge.faces;
  // An edge runs counter-clockwise around its first face.
  int start = 0;
  if (panels[0] > panels[1]) {
    std::swap(panels[0], panels[1]);
    std::swap(faces[0], faces[1]);
    start = 1;
  }
  const auto corner = [&](int side, int end) {
    const Triangle2& triangle = graph.triangles[slot_of_face[faces[side]]];
    return flat_corner(mesh, triangle, faces[side], edge.vertices[end]);
  };
  const double length = (corner(0, 1) - corner(0, 0)).norm();
  return {panels,
          {e},
          fold_angle(mesh, e),
          length,
          motion_onto(corner(1, 0), corner(1, 1), corner(0, 0), corner(0, 1)),
          {corner(0, start), corner(0, 1 - start)}};
}

// Edges this far off one line, in shares of the shorter one, are one hinge: folding both along it
// moves no corner by a tenth of what a net's congruence allows.
constexpr double kCollinear = 1e-7;

/// Whether two edges lie on one line, as all edges between two panels do up to rounding unless the
/// panels lie on each other.
bool collinear(const Mesh& mesh, int e, int f) {
  const Vec3& origin = mesh.positions[mesh.edges[e].vertices[0]];
  const Vec3 edge = mesh.positions[mesh.edges[e].vertices[1]] - origin;
  const Vec3 other =
      mesh.positions[mesh.edges[f].vertices[1]] - mesh.positions[mesh.edges[f].vertices[0]];
  const double tolerance = kCollinear * std::min(edge.norm(), other.norm());
  return std::all_of(mesh.edges[f].vertices.begin(), mesh.edges[f].vertices.end(), [&](int v) {
    return edge.normalized().cross(mesh.positions[v] - origin).norm() <= tolerance;
  });
}

void build_hinges(const Mesh& mesh, DualGraph& graph, std::span<const int> panel_of) {
  std::vector<int> slot_of_face(mesh.faces.size());
  for (int slot = 0; slot < mesh.face_count(); ++slot) slot_of_face[graph.faces[slot]] = slot;
  std::map<std::array<int, 2>, std::vector<int>> between;  // panels -> their hinges so far
  for (int e = 0; e < mesh.edge_count(); ++e) {
    const Mesh::Edge& edge = mesh.edges[e];
    if (edge.faces[1] == -1) continue;
    const std::array<int, 2> panels = {panel_of[edge.faces[0]], panel_of[edge.faces[1]]};
    if (panels[0] == panels[1]) continue;
    const auto [low, high] = std::minmax(panels[0], panels[1]);
    std::vector<int>& known = between[{low, high}];
    const auto same_line = std::find_if(known.begin(), known.end(), [&](int h) {
      return collinear(mesh, graph.hinges[h].edges[0], e);
    });
    Hinge hinge = make_hinge(mesh, graph, e, panels, slot_of_face);
    if (same_line == known.end()) {
      known.push_back(graph.hinge_count());
      graph.hinges.push_back(std::move(hinge));
    } else {
      graph.hinges[*same_line].edges.push_back(e);
      graph.hinges[*same_line].length += hinge.length;
    }
  }
}

void build_incidence(DualGraph& graph) {
  graph.first_hinge.assign(graph.panel_count() + 1, 0);
  for (const Hinge& hinge : graph.hinges) {
    for (const int panel : hinge.panels) ++graph.first_hinge[panel + 1];
  }
  for (int p = 0; p < graph.panel_count(); ++p) graph.first_hinge[p + 1] += graph.first_hinge[p];
  graph.incident.resize(graph.first_hinge.back());
  std::vector<int> next(graph.first_hinge.begin(), graph.first_hinge.end() - 1);
  for (int h = 0; h < graph.hinge_count(); ++h) {
    for (const int panel : graph.hinges[h].panels) graph.incident[next[panel]++] = h;
  }
}

}  // namespace

double fold_angle(const Mesh& mesh, int edge) {
  const Mesh::Edge& e = mesh.edges[edge];
  assert(e.faces[1] != -1);
  const Vec3 n0 = unit_normal(mesh, e.faces[0]);
  const Vec3 n1 = unit_normal(mesh, e.faces[1]);
  const Vec3 along = (mesh.positions[e.vertices[1]] - mesh.positions[e.vertices[0]]).normalized();
  // `along` keeps face 0 on its left: normals that turn forwards about it diverge, a mountain.
  const double angle = -std::atan2(n0.cross(n1).dot(along), n0.dot(n1));
  return angle > 3.14159265 ? -angle : angle;
}

DualGraph build_dual_graph(const Mesh& mesh) {
  DualGraph graph;
  graph.unit = mean_edge_length(mesh);
  const std::vector<int> panel_of = build_panels(mesh, graph);
  build_hinges(mesh, graph, panel_of);
  build_incidence(graph);
  return graph;
}

DualGraph lock_edges(const Mesh& mesh, DualGraph graph, std::span<const EdgeLock> locks) {
  if (locks.empty()) return graph;
  std::map<std::array<int, 2>, bool> is_fold;
  for (const auto& [vertices, stays] : locks) {
    is_fold[{std::min(vertices[0], vertices[1]), std::max(vertices[0], vertices[1])}] = stays;
  }
  const auto is_locked = [&](const Hinge& hinge, bool as_fold) {
    return std::ranges::any_of(hinge.edges, [&](int e) {
      const auto& [v, w] = mesh.edges[e].vertices;
      const auto lock = is_fold.find({std::min(v, w), std::max(v, w)});
      return lock != is_fold.end() && lock->second == as_fold;
    });
  };
  std::erase_if(graph.hinges, [&](const Hinge& hinge) { return is_locked(hinge, false); });
  for (Hinge& hinge : graph.hinges) hinge.stays_fold = is_locked(hinge, true);
  build_incidence(graph);
  return graph;
}

bool is_of_polygons(const DualGraph& graph) {
  return 2 * static_cast<int>(graph.triangles.size()) >= 3 * graph.panel_count();
}

DualGraph restrict_to(const DualGraph& graph, std::span<const int> panels) {
  assert(std::is_sorted(panels.begin(), panels.end()));
  DualGraph part;
  part.unit = graph.unit;
  std::vector<int> new_index(graph.panel_count(), -1);
  for (const int panel : panels) {
    new_index[panel] = part.panel_count();
    const auto faces = graph.panel_faces(panel);
    const auto triangles = graph.panel_triangles(panel);
    part.faces.insert(part.faces.end(), faces.begin(), faces.end());
    part.triangles.insert(part.triangles.end(), triangles.begin(), triangles.end());
    part.areas.push_back(graph.areas[panel]);
    part.first_face.push_back(static_cast<int>(part.faces.size()));
  }
  for (const int panel : panels) {
    for (const int h : graph.hinges_of(panel)) {
      const Hinge& hinge = graph.hinges[h];
      // Each hinge once, from its lower panel; order follows the panels, not the old numbers.
      if (hinge.panels[0] != panel || new_index[hinge.panels[1]] == -1) continue;
      Hinge copy = hinge;
      copy.panels = {new_index[hinge.panels[0]], new_index[hinge.panels[1]]};
      part.hinges.push_back(std::move(copy));
    }
  }
  build_incidence(part);
  return part;
}

std::map<int, int> hinges_by_edge(const DualGraph& graph) {
  std::map<int, int> hinges;
  for (int h = 0; h < graph.hinge_count(); ++h) hinges[graph.hinges[h].edges[0]] = h;
  return hinges;
}

}  // namespace foldwright
