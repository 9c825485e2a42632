#include "mesh/nearest_face.h"

#include <cassert>

#include "geometry/box_tree.h"
#include "geometry/triangle3.h"

namespace foldwright {
namespace {

// Weight of the normals against squared distances in mean edges; measured on the Princeton
// benchmark, where it gains half a point of Rand index.
constexpr double kNormalWeight = 0.1;

struct Target {
  Vec3 normal;
  Triangle3 corners;
};

Triangle3 corners_of(const Mesh& mesh, int face) {
  const auto& [a, b, c] = mesh.faces[face];
  return {mesh.positions[a], mesh.positions[b], mesh.positions[c]};
}

Vec3 normal_of(const Triangle3& t) { return (t[1] - t[0]).cross(t[2] - t[0]).normalized(); }

std::vector<Target> make_targets(const Mesh& mesh) {
  std::vector<Target> targets;
  for (int face = 0; face < mesh.face_count(); ++face) {
    const Triangle3 corners = corners_of(mesh, face);
    targets.push_back({normal_of(corners), corners});
  }
  return targets;
}

BoxTree make_tree(const std::vector<Target>& targets) {
  std::vector<Box3> boxes;
  for (const Target& target : targets) boxes.push_back(box_of(target.corners));
  return BoxTree(boxes);
}

}  // namespace

std::vector<int> nearest_faces(const Mesh& from, const Mesh& to) {
  assert(to.face_count() > 0);
  const std::vector<Target> targets = make_targets(to);
  const BoxTree tree = make_tree(targets);
  const double unit = mean_edge_length(to);
  const double normal_weight = kNormalWeight * unit * unit;
  std::vector<int> nearest;
  nearest.reserve(from.faces.size());
  for (int face = 0; face < from.face_count(); ++face) {
    const Triangle3 corners = corners_of(from, face);
    const Vec3 point = (corners[0] + corners[1] + corners[2]) / 3;
    const Vec3 normal = normal_of(corners);
    const auto cost = [&](int i) {
      return (closest_point(targets[i].corners, point) - point).squaredNorm() +
             normal_weight * (1 - normal.dot(targets[i].normal));
    };
    // Neighbours in a file are mostly neighbours in space: the last answer is a good first bound.
    int best = nearest.empty() ? 0 : nearest.back();
    double least = cost(best);
    // The distance alone is no more than the cost.
    tree.visit_near(point, least, [&](int i) {
      const double value = cost(i);
      if (value < least || (value == least && i < best)) least = value, best = i;
      return least;
    });
    nearest.push_back(best);
  }
  return nearest;
}

}  // namespace foldwright
