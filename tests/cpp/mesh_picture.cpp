#include "mesh_picture.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>

namespace foldwright::testing {
namespace {

constexpr double kAmbient = 0.45;                    // of the light that a face turned away gets
constexpr Colour kBorder = {0.12, 0.12, 0.14};       // of lines between parts
constexpr double kTilt = 0.3;                        // of `widest_eye` from the side to above
const Vec3 kLight = Vec3(0.3, 0.5, 1).normalized();  // in the eye's axes

Vec3 centroid(const Mesh& mesh, int face) {
  const auto& [a, b, c] = mesh.faces[face];
  return (mesh.positions[a] + mesh.positions[b] + mesh.positions[c]) / 3;
}

/// Positions in the eye's axes: right, up, towards it.
std::vector<Vec3> seen_by(const Eye& eye, const Mesh& mesh) {
  const Vec3 z = eye.toward.normalized();
  const Vec3 x = eye.up.cross(z).normalized();
  const Vec3 y = z.cross(x);
  std::vector<Vec3> seen;
  for (const Vec3& p : mesh.positions) seen.emplace_back(p.dot(x), p.dot(y), p.dot(z));
  return seen;
}

/// Fits what is seen into a box, y down.
class Frame {
 public:
  Frame(const PictureBox& box, const std::vector<Vec3>& seen) {
    Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
    for (const Vec3& p : seen) low = low.cwiseMin(p), high = high.cwiseMax(p);
    const Vec3 size = high - low;
    scale_ = std::min(box.width / size.x(), box.height / size.y());
    middle_ = ((low + high) / 2).head<2>();
    centre_ = {box.x + box.width / 2, box.y + box.height / 2};
  }

  Vec2 operator()(const Vec3& p) const {
    return {centre_.x() + scale_ * (p.x() - middle_.x()),
            centre_.y() - scale_ * (p.y() - middle_.y())};
  }

 private:
  double scale_ = 1;
  Vec2 middle_, centre_;
};

}  // namespace

Eye widest_eye(const Mesh& mesh, bool behind) {
  Vec3 mean = Vec3::Zero();
  double area = 0;
  for (int face = 0; face < mesh.face_count(); ++face) {
    mean += face_area(mesh, face) * centroid(mesh, face);
    area += face_area(mesh, face);
  }
  mean /= area;
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (int face = 0; face < mesh.face_count(); ++face) {
    const Vec3 arm = centroid(mesh, face) - mean;
    spread += face_area(mesh, face) * arm * arm.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(spread);
  Vec3 side = solver.eigenvectors().col(0);
  // What stands upright in the file is its y axis, or z where the model lies flat on that.
  const Vec3 up = std::abs(side.y()) < 0.8 ? Vec3(0, 1, 0) : Vec3(0, 0, 1);
  side = (side - side.dot(up) * up).normalized();
  if (side.sum() < 0) side = -side;
  if (behind) side = -side;
  const Vec3 aside = up.cross(side);
  return {side + kTilt * up + kTilt * aside, up};
}

void draw_mesh(SvgCanvas& canvas, const PictureBox& box, const Mesh& mesh,
               std::span<const int> labels, const Eye& eye) {
  assert(labels.size() == mesh.faces.size());
  const std::vector<Vec3> seen = seen_by(eye, mesh);
  const Frame frame(box, seen);
  const bool closed = std::all_of(mesh.edges.begin(), mesh.edges.end(),
                                  [](const Mesh::Edge& edge) { return edge.faces[1] != -1; });
  std::vector<int> order(mesh.faces.size());
  std::iota(order.begin(), order.end(), 0);
  std::vector<double> depth;
  for (const auto& [a, b, c] : mesh.faces) depth.push_back(seen[a].z() + seen[b].z() + seen[c].z());
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return depth[a] < depth[b]; });
  for (const int face : order) {
    const auto& [a, b, c] = mesh.faces[face];
    const Vec3 normal = (seen[b] - seen[a]).cross(seen[c] - seen[a]);
    // Only open meshes show the insides of their faces, in shade.
    if (normal.norm() == 0 || (closed && normal.z() < 0)) continue;
    const double light = std::max(0.0, normal.normalized().dot(kLight));
    const std::array<Vec2, 3> corners = {frame(seen[a]), frame(seen[b]), frame(seen[c])};
    const Colour colour = part_colour(std::max(0, labels[face]));
    canvas.polygon(corners, colour.times(kAmbient + (1 - kAmbient) * light));
    for (int i = 0; i < 3; ++i) {
      const Mesh::Edge& edge = mesh.edges[mesh.face_edges[face][i]];
      if (edge.faces[1] == -1 || labels[edge.faces[0]] == labels[edge.faces[1]]) continue;
      canvas.line(corners[i], corners[(i + 1) % 3], 1, kBorder);
    }
  }
}

}  // namespace foldwright::testing
