#include "repair/crossing_bodies.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "geometry/box_pairs.h"
#include "geometry/triangle3.h"

namespace foldwright {
namespace {

constexpr int kMostFaces = 200'000;

// Faces that go into each other by less than this share of the model's extent touch: a tenth of a
// millimetre on ten centimetres is less than paper is thick.
constexpr double kDepth = 1e-3;

// Small faces touch when it is less than this share of their size.
constexpr double kShareOfFace = 0.1;

Triangle3 corners_of(const Mesh& mesh, int face) {
  const auto& [a, b, c] = mesh.faces[face];
  return {mesh.positions[a], mesh.positions[b], mesh.positions[c]};
}

int shared_corners(const Mesh& mesh, int face, int other) {
  int shared = 0;
  for (const int v : mesh.faces[face]) shared += std::ranges::count(mesh.faces[other], v) > 0;
  return shared;
}

double extent_of(const Mesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Vec3& p : mesh.positions) box.extend(p);
  return box.diagonal().norm();
}

bool faces_cross(const Triangle3& a, const Triangle3& b, double depth) {
  const auto size = [](const Triangle3& t) {
    return std::sqrt((t[1] - t[0]).cross(t[2] - t[0]).norm());
  };
  return triangles_cross(a, b, std::min(depth, kShareOfFace * std::min(size(a), size(b))));
}

}  // namespace

Crossings find_crossings(const Mesh& mesh) {
  Crossings crossings;
  if (mesh.face_count() > kMostFaces) {
    crossings.checked = false;
    return crossings;
  }
  const double depth = kDepth * extent_of(mesh);
  std::vector<Box3> boxes;
  for (int f = 0; f < mesh.face_count(); ++f) boxes.push_back(box_of(corners_of(mesh, f)));
  std::vector<std::pair<int, int>> found;  // components, the lower first
  for (const auto& [f, g] : meeting_boxes(boxes)) {
    const std::pair<int, int> bodies = std::minmax(mesh.components[f], mesh.components[g]);
    if (shared_corners(mesh, f, g) > 0) continue;
    if (faces_cross(corners_of(mesh, f), corners_of(mesh, g), depth)) found.push_back(bodies);
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  for (const auto& [body, other] : found) ++(body == other ? crossings.bodies : crossings.pairs);
  return crossings;
}

}  // namespace foldwright
