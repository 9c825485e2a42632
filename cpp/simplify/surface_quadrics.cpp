#include "simplify/surface_quadrics.h"

#include "mesh/surface_tree.h"

namespace foldwright {
namespace {

// Leaving a border costs as much as leaving a face beside it that is ten times as long as wide:
// the outline of a sheet is what is seen of it. Edges between regions weigh less, since they move
// along a surface that holds them as well.
constexpr double kBorderWeight = 10;
constexpr double kRegionWeight = 1;

double weight_of(const Mesh::Edge& edge, std::span<const int> regions,
                 const std::optional<SymmetryPlane>& plane) {
  const auto [a, b] = edge.vertices;
  if (edge.faces[1] < 0) return plane && plane->is_on[a] && plane->is_on[b] ? 0 : kBorderWeight;
  if (regions.empty()) return 0;
  return regions[edge.faces[0]] != regions[edge.faces[1]] ? kRegionWeight : 0;
}

Vec3 area_vector(const Triangle3& t) { return 0.5 * (t[1] - t[0]).cross(t[2] - t[0]); }

/// Adds the plane through an edge that stands upright on a face beside it.
void add_wall(const Mesh& mesh, const Mesh::Edge& edge, int face, double weight,
              std::vector<Quadric>& quadrics) {
  const Vec3& from = mesh.positions[edge.vertices[0]];
  const Vec3 along = mesh.positions[edge.vertices[1]] - from;
  const Vec3 across = along.cross(area_vector(corners_of(mesh, face)));
  if (across.squaredNorm() == 0) return;
  for (const int v : edge.vertices) {
    quadrics[v].add_plane(across.normalized(), from, weight * along.squaredNorm() / 3);
  }
}

}  // namespace

std::vector<Quadric> surface_quadrics(const Mesh& mesh, std::span<const int> regions,
                                      const std::optional<SymmetryPlane>& plane) {
  std::vector<Quadric> quadrics(mesh.positions.size());
  for (int face = 0; face < mesh.face_count(); ++face) {
    const Triangle3 t = corners_of(mesh, face);
    const Vec3 area = area_vector(t);
    const double size = area.norm();
    if (size == 0) continue;
    for (const int v : mesh.faces[face]) quadrics[v].add_plane(area / size, t[0], size / 3);
  }
  for (const Mesh::Edge& edge : mesh.edges) {
    const double weight = weight_of(edge, regions, plane);
    if (weight == 0) continue;
    for (const int face : edge.faces) {
      if (face >= 0) add_wall(mesh, edge, face, weight, quadrics);
    }
  }
  return quadrics;
}

}  // namespace foldwright
