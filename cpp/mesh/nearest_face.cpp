#include "mesh/nearest_face.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace foldwright {
namespace {

// Weight of the normals against squared distances in mean edges; measured on the Princeton
// benchmark, where it gains half a point of Rand index.
constexpr double kNormalWeight = 0.1;

/// A face as the queries need it: a ball around it for the bound, its corners for the distance.
struct Target {
  Vec3 centre;
  double radius;
  Vec3 normal;
  std::array<Vec3, 3> corners;
};

std::array<Vec3, 3> corners_of(const Mesh& mesh, int face) {
  const auto& [a, b, c] = mesh.faces[face];
  return {mesh.positions[a], mesh.positions[b], mesh.positions[c]};
}

Vec3 normal_of(const std::array<Vec3, 3>& t) {
  return (t[1] - t[0]).cross(t[2] - t[0]).normalized();
}

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
    Target target{Vec3::Zero(), 0, Vec3::Zero(), corners_of(mesh, face)};
    target.centre = (target.corners[0] + target.corners[1] + target.corners[2]) / 3;
    target.normal = normal_of(target.corners);
    for (const Vec3& corner : target.corners) {
      target.radius = std::max(target.radius, (corner - target.centre).norm());
    }
    targets.push_back(target);
  }
  return targets;
}

}  // namespace

std::vector<int> nearest_faces(const Mesh& from, const Mesh& to) {
  assert(to.face_count() > 0);
  const std::vector<Target> targets = make_targets(to);
  const double unit = mean_edge_length(to);
  const double normal_weight = kNormalWeight * unit * unit;
  std::vector<int> nearest;
  nearest.reserve(from.faces.size());
  for (int face = 0; face < from.face_count(); ++face) {
    const std::array<Vec3, 3> corners = corners_of(from, face);
    const Vec3 point = (corners[0] + corners[1] + corners[2]) / 3;
    const Vec3 normal = normal_of(corners);
    const auto cost = [&](int i) {
      return triangle_distance2(point, targets[i]) +
             normal_weight * (1 - normal.dot(targets[i].normal));
    };
    // Neighbours in a file are mostly neighbours in space: the last answer is a good first bound.
    int best = nearest.empty() ? 0 : nearest.back();
    double least = cost(best);
    double reach = std::sqrt(least);
    for (int i = 0; i < static_cast<int>(targets.size()); ++i) {
      const double bound = targets[i].radius + reach;
      if ((point - targets[i].centre).squaredNorm() > bound * bound) continue;
      const double value = cost(i);
      if (value > least || (value == least && i >= best)) continue;
      least = value;
      best = i;
      reach = std::sqrt(least);
    }
    nearest.push_back(best);
  }
  return nearest;
}

}  // namespace foldwright
