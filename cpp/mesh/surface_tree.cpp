#include "mesh/surface_tree.h"

namespace foldwright {
namespace {

std::vector<Triangle3> all_corners(const Mesh& mesh) {
  std::vector<Triangle3> corners;
  for (int face = 0; face < mesh.face_count(); ++face) corners.push_back(corners_of(mesh, face));
  return corners;
}

BoxTree tree_of(const std::vector<Triangle3>& triangles) {
  std::vector<Box3> boxes;
  for (const Triangle3& triangle : triangles) boxes.push_back(box_of(triangle));
  return BoxTree(boxes);
}

}  // namespace

Triangle3 corners_of(const Mesh& mesh, int face) {
  const auto& [a, b, c] = mesh.faces[face];
  return {mesh.positions[a], mesh.positions[b], mesh.positions[c]};
}

Vec3 normal_of(const Triangle3& t) { return (t[1] - t[0]).cross(t[2] - t[0]).normalized(); }

SurfaceTree::SurfaceTree(const Mesh& mesh) : corners_(all_corners(mesh)), tree_(tree_of(corners_)) {
  for (const Triangle3& triangle : corners_) normals_.push_back(normal_of(triangle));
}

int SurfaceTree::nearest(const Vec3& point, int guess) const {
  int best = guess;
  double least = squared_distance(guess, point);
  visit_near(point, least, [&](int face) {
    const double value = squared_distance(face, point);
    if (value < least) least = value, best = face;
    return least;
  });
  return best;
}

}  // namespace foldwright
