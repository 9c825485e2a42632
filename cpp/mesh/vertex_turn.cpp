#include "mesh/vertex_turn.h"

#include <cmath>

namespace foldwright {
namespace {

void add_turns(const Mesh& mesh, int face, std::vector<double>& turns) {
  const auto& corners = mesh.faces[face];
  for (int i = 0; i < 3; ++i) {
    const Vec3& apex = mesh.positions[corners[i]];
    const Vec3 a = mesh.positions[corners[(i + 1) % 3]] - apex;
    const Vec3 b = mesh.positions[corners[(i + 2) % 3]] - apex;
    turns[corners[i]] += std::atan2(a.cross(b).norm(), a.dot(b));
  }
}

}  // namespace

std::vector<double> vertex_turns(const Mesh& mesh, std::span<const int> faces) {
  std::vector<double> turns(mesh.positions.size(), 0);
  for (const int face : faces) add_turns(mesh, face, turns);
  return turns;
}

std::vector<double> vertex_turns(const Mesh& mesh) {
  std::vector<double> turns(mesh.positions.size(), 0);
  for (int face = 0; face < mesh.face_count(); ++face) add_turns(mesh, face, turns);
  return turns;
}

}  // namespace foldwright
