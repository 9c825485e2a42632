#include "simplify/mirror_half.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "mesh/surface_tree.h"

namespace foldwright {
namespace {

// Share of the diagonal of the box: less than simplifying moves the surface of a paper model.
constexpr double kSame = 0.005;

// Vertices nearer to the plane than this share of the shortest edge at them are moved onto it:
// triangles cut off there would be slivers.
constexpr double kSnap = 0.25;

double diagonal_of(const Mesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Vec3& p : mesh.positions) box.extend(p);
  return box.diagonal().norm();
}

/// Heights of vertices over a plane, 0 for those that are moved onto it.
std::vector<double> snapped_heights(const Mesh& mesh, const Mirror& mirror) {
  std::vector<double> shortest(mesh.positions.size(), INFINITY);
  for (const Mesh::Edge& edge : mesh.edges) {
    const auto [a, b] = edge.vertices;
    const double length = (mesh.positions[a] - mesh.positions[b]).norm();
    for (const int v : edge.vertices) shortest[v] = std::min(shortest[v], length);
  }
  std::vector<double> heights;
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    const double height = mirror.normal.dot(mesh.positions[v]) - mirror.offset;
    heights.push_back(std::abs(height) <= kSnap * shortest[v] ? 0 : height);
  }
  return heights;
}

/// Cuts faces by a plane, one after the other.
class Cutter {
 public:
  Cutter(const Mesh& mesh, const Mirror& mirror)
      : mesh_(mesh), mirror_(mirror), heights_(snapped_heights(mesh, mirror)) {}

  /// False when a face lies in the plane.
  bool cut(int face) {
    const auto& corners = mesh_.faces[face];
    if (std::ranges::all_of(corners, [&](int v) { return heights_[v] == 0; })) return false;
    std::vector<int> polygon;
    for (int i = 0; i < 3; ++i) {
      const int from = corners[i];
      const int to = corners[(i + 1) % 3];
      if (heights_[from] >= 0) polygon.push_back(vertex_of(from));
      if (heights_[from] * heights_[to] < 0) polygon.push_back(vertex_between(from, to));
    }
    add_polygon(polygon, face);
    return true;
  }

  /// None when an edge of the half in the plane has a face on either side.
  std::optional<MirrorHalf> take() {
    MirrorHalf half{make_mesh(std::move(positions_), std::move(faces_), std::move(sources_)),
                    {mirror_.normal, mirror_.offset, {}}};
    half.plane.is_on.assign(is_in_plane_.size(), false);
    for (const Mesh::Edge& edge : half.mesh.edges) {
      const auto [a, b] = edge.vertices;
      if (!is_in_plane_[a] || !is_in_plane_[b]) continue;
      if (edge.faces[1] >= 0) return std::nullopt;
      half.plane.is_on[a] = half.plane.is_on[b] = true;
    }
    return half;
  }

 private:
  void add_polygon(const std::vector<int>& polygon, int face) {
    const auto touches = std::ranges::count_if(polygon, [&](int v) { return is_in_plane_[v]; });
    if (polygon.size() < 3 || touches == static_cast<int>(polygon.size())) return;
    if (polygon.size() == 3) {
      add_face({polygon[0], polygon[1], polygon[2]}, face);
      return;
    }
    // A triangle that loses one corner: four are left, and the shorter diagonal parts them.
    const auto length = [&](int i, int j) {
      return (positions_[polygon[i]] - positions_[polygon[j]]).norm();
    };
    const int first = length(0, 2) <= length(1, 3) ? 0 : 1;
    const auto at = [&](int i) { return polygon[(first + i) % 4]; };
    add_face({at(0), at(1), at(2)}, face);
    add_face({at(0), at(2), at(3)}, face);
  }

  void add_face(const std::array<int, 3>& vertices, int face) {
    faces_.push_back(vertices);
    sources_.push_back(face);
  }

  int vertex_of(int v) {
    const auto [entry, is_new] = numbers_.try_emplace({v, v}, next_number());
    if (is_new) {
      const bool is_in = heights_[v] == 0;
      add_vertex(is_in ? in_plane(mesh_.positions[v]) : mesh_.positions[v], is_in);
    }
    return entry->second;
  }

  int vertex_between(int from, int to) {
    const auto [a, b] = std::minmax(from, to);
    const auto [entry, is_new] = numbers_.try_emplace({a, b}, next_number());
    if (is_new) {
      const double t = heights_[a] / (heights_[a] - heights_[b]);
      add_vertex(in_plane(mesh_.positions[a] + t * (mesh_.positions[b] - mesh_.positions[a])),
                 true);
    }
    return entry->second;
  }

  int next_number() const { return static_cast<int>(positions_.size()); }

  void add_vertex(const Vec3& position, bool is_in_plane) {
    positions_.push_back(position);
    is_in_plane_.push_back(is_in_plane);
  }

  Vec3 in_plane(const Vec3& p) const {
    return p - (mirror_.normal.dot(p) - mirror_.offset) * mirror_.normal;
  }

  const Mesh& mesh_;
  const Mirror& mirror_;
  std::vector<double> heights_;
  std::map<std::pair<int, int>, int> numbers_;  ///< of vertices, and of edges that are cut
  std::vector<Vec3> positions_;
  std::vector<bool> is_in_plane_;
  std::vector<std::array<int, 3>> faces_;
  std::vector<int> sources_;
};

}  // namespace

bool mirrors_itself(const Mesh& mesh, const Mirror& mirror) {
  const SurfaceTree surface(mesh);
  const double far = kSame * diagonal_of(mesh);
  int nearest = 0;
  return std::ranges::all_of(mesh.positions, [&](const Vec3& p) {
    const Vec3 image = mirror.image(p);
    nearest = surface.nearest(image, nearest);
    return surface.squared_distance(nearest, image) <= far * far;
  });
}

std::optional<MirrorHalf> half_in_front(const Mesh& mesh, const Mirror& mirror) {
  Cutter cutter(mesh, mirror);
  for (int face = 0; face < mesh.face_count(); ++face) {
    if (!cutter.cut(face)) return std::nullopt;
  }
  return cutter.take();
}

Mesh with_image(const CollapsedMesh& half, const SymmetryPlane& plane) {
  std::vector<Vec3> positions = half.positions;
  std::vector<int> images;
  for (std::size_t v = 0; v < half.positions.size(); ++v) {
    if (half.is_on_plane[v]) {
      images.push_back(static_cast<int>(v));
      continue;
    }
    const Vec3& p = half.positions[v];
    images.push_back(static_cast<int>(positions.size()));
    positions.push_back(p - 2 * (plane.normal.dot(p) - plane.offset) * plane.normal);
  }
  std::vector<std::array<int, 3>> faces = half.faces;
  for (const auto& [a, b, c] : half.faces) faces.push_back({images[a], images[c], images[b]});
  return make_mesh(std::move(positions), std::move(faces));
}

}  // namespace foldwright
