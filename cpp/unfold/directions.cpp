#include "unfold/directions.h"

#include <utility>

namespace foldwright {
namespace {

std::vector<Vec3> face_normals(const Mesh& mesh) {
  std::vector<Vec3> normals;
  for (const auto& [a, b, c] : mesh.faces) {
    normals.push_back((mesh.positions[b] - mesh.positions[a])
                          .cross(mesh.positions[c] - mesh.positions[a])
                          .normalized());
  }
  return normals;
}

/// Area-weighted: the cross products of the faces around, summed.
std::vector<Vec3> vertex_normals(const Mesh& mesh) {
  std::vector<Vec3> normals(mesh.positions.size(), Vec3::Zero());
  for (const auto& [a, b, c] : mesh.faces) {
    const Vec3 normal =
        (mesh.positions[b] - mesh.positions[a]).cross(mesh.positions[c] - mesh.positions[a]);
    for (const int v : {a, b, c}) normals[v] += normal;
  }
  for (Vec3& normal : normals) normal.normalize();
  return normals;
}

std::vector<Vec3> edge_directions(const Mesh& mesh) {
  std::vector<Vec3> directions;
  for (const Mesh::Edge& edge : mesh.edges) {
    directions.push_back(
        (mesh.positions[edge.vertices[1]] - mesh.positions[edge.vertices[0]]).normalized());
  }
  return directions;
}

std::vector<Vec3> surface_directions(const Mesh& mesh, DirectionSet set) {
  switch (set) {
    case DirectionSet::kFaceNormals:
      return face_normals(mesh);
    case DirectionSet::kVertexNormals:
      return vertex_normals(mesh);
    default:
      return edge_directions(mesh);
  }
}

}  // namespace

Vec3 random_direction(Random& random) {
  // Rejection from the cube: uniform on the sphere, and free of libm's rounding.
  while (true) {
    const double x = 2 * random.uniform() - 1;
    const double y = 2 * random.uniform() - 1;
    const double z = 2 * random.uniform() - 1;
    const double square = x * x + y * y + z * z;
    if (square > 1e-4 && square <= 1) return Vec3(x, y, z) / std::sqrt(square);
  }
}

std::vector<Vec3> make_directions(const Mesh& mesh, DirectionSet set, int count, Random& random) {
  std::vector<Vec3> chosen;
  if (set == DirectionSet::kRandom) {
    while (static_cast<int>(chosen.size()) < count) chosen.push_back(random_direction(random));
    return chosen;
  }
  std::vector<Vec3> pool = surface_directions(mesh, set);
  const int size = static_cast<int>(pool.size());
  for (int i = 0; i < count; ++i) {
    const int at = i % size;  // Fisher-Yates, one step per vector taken
    std::swap(pool[at], pool[at + random.below(size - at)]);
    chosen.push_back(pool[at]);
  }
  return chosen;
}

}  // namespace foldwright
