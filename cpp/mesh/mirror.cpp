#include "mesh/mirror.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "geometry/box_tree.h"
#include "geometry/triangle3.h"

namespace foldwright {
namespace {

// Samples per plane: few tell which planes are worth refining, more where exactly they are.
constexpr int kScreened = 100;
constexpr int kRefined = 400;

// Directions over a hemisphere, some 15 degrees apart: closest points find their way from there.
constexpr int kDirections = 80;

// Planes that are refined, and steps each: the error settles within five.
constexpr int kCandidates = 6;
constexpr int kSteps = 6;

// A sample this far off its mirror image, in root mean square radii, counts half: nearly symmetric
// models have tails and raised arms.
constexpr double kOutlier = 0.05;

struct Sample {
  Vec3 point;
  int face;
};

struct Nearest {
  Vec3 point;
  int face;
};

/// A surface that finds its nearest points.
class SurfaceQuery {
 public:
  explicit SurfaceQuery(std::vector<Triangle3> triangles)
      : triangles_(std::move(triangles)), tree_(boxes_of(triangles_)) {}

  /// `guess`: a face that may be near.
  Nearest nearest(const Vec3& p, int guess) const {
    Nearest best{closest_point(triangles_[guess], p), guess};
    double least = (best.point - p).squaredNorm();
    tree_.visit_near(p, least, [&](int i) {
      const Vec3 point = closest_point(triangles_[i], p);
      const double distance = (point - p).squaredNorm();
      if (distance < least) least = distance, best = {point, i};
      return least;
    });
    return best;
  }

  const std::vector<Triangle3>& triangles() const { return triangles_; }

 private:
  static std::vector<Box3> boxes_of(const std::vector<Triangle3>& triangles) {
    std::vector<Box3> boxes;
    for (const Triangle3& t : triangles) boxes.push_back(box_of(t));
    return boxes;
  }

  std::vector<Triangle3> triangles_;
  BoxTree tree_;
};

std::vector<Triangle3> triangles_of(const Mesh& mesh, std::span<const int> faces) {
  std::vector<Triangle3> triangles;
  for (const int face : faces) {
    const auto& [a, b, c] = mesh.faces[face];
    triangles.push_back({mesh.positions[a], mesh.positions[b], mesh.positions[c]});
  }
  return triangles;
}

Vec3 area_vector(const Triangle3& t) { return 0.5 * (t[1] - t[0]).cross(t[2] - t[0]); }

/// Points spread evenly by area: a low-discrepancy sequence within the faces, which are passed
/// through in steps of equal area.
std::vector<Sample> make_samples(const std::vector<Triangle3>& triangles, int count) {
  double total = 0;
  for (const Triangle3& t : triangles) total += area_vector(t).norm();
  // Steps of the plane's generalised golden ratio (Roberts 2018).
  constexpr double kRatio = 1.32471795724474602596;
  std::vector<Sample> samples;
  int face = 0;
  double before = 0;
  for (int i = 0; i < count; ++i) {
    const double wanted = total * (i + 0.5) / count;
    while (face + 1 < static_cast<int>(triangles.size()) &&
           before + area_vector(triangles[face]).norm() < wanted) {
      before += area_vector(triangles[face++]).norm();
    }
    double u = std::fmod((i + 1) / kRatio, 1.0);
    double v = std::fmod((i + 1) / (kRatio * kRatio), 1.0);
    if (u + v > 1) u = 1 - u, v = 1 - v;
    const Triangle3& t = triangles[face];
    samples.push_back({t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]), face});
  }
  return samples;
}

/// Centroid and second moments of samples.
struct Moments {
  Vec3 centroid = Vec3::Zero();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();

  explicit Moments(std::span<const Sample> samples) {
    const auto count = static_cast<double>(samples.size());
    for (const Sample& s : samples) centroid += s.point / count;
    for (const Sample& s : samples) {
      const Vec3 arm = s.point - centroid;
      covariance += arm * arm.transpose() / count;
    }
  }

  double radius() const { return std::sqrt(covariance.trace()); }
};

double mean_error(const SurfaceQuery& surface, std::span<const Sample> samples,
                  const Mirror& mirror) {
  double sum = 0;
  for (const Sample& s : samples) {
    const Vec3 image = mirror.image(s.point);
    sum += (surface.nearest(image, s.face).point - image).norm();
  }
  return sum / static_cast<double>(samples.size());
}

/// Normals to try: the principal axes, and directions all over a hemisphere, on a spiral.
std::vector<Vec3> make_normals(const Moments& moments) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(moments.covariance);
  std::vector<Vec3> normals;
  for (int i = 0; i < 3; ++i) normals.emplace_back(axes.eigenvectors().col(i));
  for (int i = 0; i < kDirections; ++i) {
    const double z = (i + 0.5) / kDirections;
    const double angle = 2 * std::numbers::pi * i / std::numbers::phi;
    const double r = std::sqrt(1 - z * z);
    normals.emplace_back(r * std::cos(angle), r * std::sin(angle), z);
  }
  return normals;
}

/// One step of Gauss and Newton on the distances of images from the planes of their nearest faces,
/// in the two turns of the normal and the offset.
Mirror refined(const SurfaceQuery& surface, std::span<const Sample> samples, double radius,
               const Vec3& centre, const Mirror& mirror) {
  const Vec3 u = mirror.normal.unitOrthogonal();
  const Vec3 v = mirror.normal.cross(u);
  // A little damping: a surface of revolution has a whole pencil of planes.
  Eigen::Matrix3d normal_matrix = 1e-6 * static_cast<double>(samples.size()) *
                                  Vec3(radius * radius, radius * radius, 1).asDiagonal();
  Vec3 right = Vec3::Zero();
  const double offset = mirror.offset - mirror.normal.dot(centre);
  for (const Sample& s : samples) {
    const Vec3 image = mirror.image(s.point);
    const Nearest nearest = surface.nearest(image, s.face);
    const Vec3 face_normal = area_vector(surface.triangles()[nearest.face]).normalized();
    const double along = face_normal.dot(mirror.normal);
    const Vec3 arm = s.point - centre;
    const Vec3 turn = along * arm + (mirror.normal.dot(arm) - offset) * face_normal;
    const Vec3 slope = -2 * Vec3(turn.dot(u), turn.dot(v), -along);
    const double far = (image - nearest.point).norm() / (kOutlier * radius);
    const double weight = 1 / (1 + far * far);
    normal_matrix += weight * slope * slope.transpose();
    right -= weight * face_normal.dot(image - nearest.point) * slope;
  }
  const Vec3 step = normal_matrix.ldlt().solve(right);
  Mirror better = mirror;
  better.normal = (mirror.normal + step.x() * u + step.y() * v).normalized();
  better.offset = offset + step.z() + better.normal.dot(centre);
  return better;
}

}  // namespace

std::optional<Mirror> find_mirror(const Mesh& mesh, std::span<const int> faces, double tolerance) {
  const SurfaceQuery surface(triangles_of(mesh, faces));
  const std::vector<Sample> few = make_samples(surface.triangles(), kScreened);
  const std::vector<Sample> many = make_samples(surface.triangles(), kRefined);
  const Moments moments(many);
  const double radius = moments.radius();
  std::vector<Mirror> mirrors;
  for (const Vec3& normal : make_normals(moments)) {
    Mirror mirror{normal, normal.dot(moments.centroid), 0};
    mirror.error = mean_error(surface, few, mirror) / radius;
    mirrors.push_back(mirror);
  }
  const auto by_error = [](const Mirror& a, const Mirror& b) { return a.error < b.error; };
  std::stable_sort(mirrors.begin(), mirrors.end(), by_error);
  mirrors.resize(kCandidates);
  for (Mirror& mirror : mirrors) {
    for (int step = 0; step < kSteps; ++step) {
      mirror = refined(surface, many, radius, moments.centroid, mirror);
    }
    mirror.error = mean_error(surface, many, mirror) / radius;
  }
  const Mirror best = *std::min_element(mirrors.begin(), mirrors.end(), by_error);
  if (!(best.error <= tolerance)) return std::nullopt;
  return best;
}

}  // namespace foldwright
