#include "face_crossings.h"

#include <algorithm>

#include "geometry/box_pairs.h"
#include "geometry/face_contact.h"
#include "mesh/surface_tree.h"

namespace foldwright::testing {
namespace {

bool share_a_vertex(const Mesh& mesh, int face, int other) {
  const auto& vertices = mesh.faces[other];
  return std::ranges::any_of(mesh.faces[face],
                             [&](int v) { return std::ranges::count(vertices, v) > 0; });
}

}  // namespace

int crossing_count(const Mesh& mesh) {
  Eigen::AlignedBox3d extent;
  for (const Vec3& p : mesh.positions) extent.extend(p);
  std::vector<Box3> boxes;
  for (int f = 0; f < mesh.face_count(); ++f) boxes.push_back(box_of(corners_of(mesh, f)));
  int count = 0;
  for (const auto& [f, g] : meeting_boxes(boxes)) {
    count += !share_a_vertex(mesh, f, g) &&
             faces_cross(corners_of(mesh, f), corners_of(mesh, g), extent.diagonal().norm());
  }
  return count;
}

Mesh both(const Mesh& first, const Mesh& second, const Vec3& shift) {
  std::vector<Vec3> positions = first.positions;
  std::vector<std::array<int, 3>> faces = first.faces;
  for (const Vec3& p : second.positions) positions.push_back(p + shift);
  for (auto face : second.faces) {
    for (int& v : face) v += first.vertex_count();
    faces.push_back(face);
  }
  return make_mesh(std::move(positions), std::move(faces));
}

}  // namespace foldwright::testing
