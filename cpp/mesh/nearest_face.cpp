#include "mesh/nearest_face.h"

#include <algorithm>
#include <cassert>
#include <cmath>

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

double segment_distance2(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 along = b - a;
  const double t = std::clamp((p - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (a + t * along - p).squaredNorm();
}

double triangle_distance2(const Vec3& p, const Target& t) {
  const auto& [a, b, c] = t.corners;
  const bool over_face = t.normal.dot((b - a).cross(p - a)) >= 0 &&
                         t.normal.dot((c - b).cross(p - b)) >= 0 &&
                         t.normal.dot((a - c).cross(p - c)) >= 0;
  if (over_face) {
    const double height = t.normal.dot(p - a);
    return height * height;
  }
  return std::min(
      {segment_distance2(p, a, b), segment_distance2(p, b, c), segment_distance2(p, c, a)});
}

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
      return triangle_distance2(point, targets[i]) +
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
