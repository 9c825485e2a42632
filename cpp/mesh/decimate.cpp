#include "mesh/decimate.h"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalFlippingT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#include <algorithm>
#include <utility>

#include "mesh/nearest_face.h"

namespace foldwright {
namespace {

struct DecimaterTraits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};
using HalfedgeMesh = OpenMesh::TriMesh_ArrayKernelT<DecimaterTraits>;
using Decimater = OpenMesh::Decimater::DecimaterT<HalfedgeMesh>;

/// Squared distance of a point from a segment.
double squared_distance(const OpenMesh::Vec3d& p, const OpenMesh::Vec3d& a,
                        const OpenMesh::Vec3d& b) {
  const OpenMesh::Vec3d along = b - a;
  const double length = along.sqrnorm();
  const double t = length > 0 ? std::clamp(along.dot(p - a) / length, 0.0, 1.0) : 0;
  return (a + t * along - p).sqrnorm();
}

/// Quadric error that also counts by how much a collapse moves the border. The plain one knows the
/// planes of the faces alone: it would cut off the corners of a flat sheet for nothing.
class ModBorderQuadric : public OpenMesh::Decimater::ModQuadricT<HalfedgeMesh> {
 public:
  using Quadric = OpenMesh::Decimater::ModQuadricT<HalfedgeMesh>;
  using Handle = OpenMesh::Decimater::ModHandleT<ModBorderQuadric>;
  using Quadric::Quadric;

  float collapse_priority(const CollapseInfo& collapse) override {
    const float error = Quadric::collapse_priority(collapse);
    const HalfedgeMesh& mesh = Base::mesh();
    if (error < 0 || !mesh.is_boundary(collapse.v0)) return error;  // negative: not allowed
    const auto outgoing = mesh.halfedge_handle(collapse.v0);  // a border half-edge, by convention
    const auto next = mesh.to_vertex_handle(outgoing);
    const auto previous = mesh.from_vertex_handle(mesh.prev_halfedge_handle(outgoing));
    const double moved =
        squared_distance(mesh.point(collapse.v0), mesh.point(previous), mesh.point(next));
    // As much as the some six faces of an inner vertex would count if they all moved as far.
    constexpr double kBorderWeight = 6;
    return error + static_cast<float>(kBorderWeight * moved);
  }
};

HalfedgeMesh to_halfedges(const Mesh& mesh) {
  HalfedgeMesh result;
  result.reserve(mesh.positions.size(), mesh.edges.size(), mesh.faces.size());
  // Quadric errors are fourth powers of lengths: in units of the mean edge they neither under- nor
  // overflow, whatever the model's unit.
  const double scale = 1 / mean_edge_length(mesh);
  for (const Vec3& p : mesh.positions) {
    result.add_vertex(scale * OpenMesh::Vec3d(p.x(), p.y(), p.z()));
  }
  for (const auto& [a, b, c] : mesh.faces) {
    result.add_face(HalfedgeMesh::VertexHandle(a), HalfedgeMesh::VertexHandle(b),
                    HalfedgeMesh::VertexHandle(c));
  }
  return result;
}

Mesh from_halfedges(const HalfedgeMesh& halfedges, double scale) {
  std::vector<Vec3> positions;
  for (const auto v : halfedges.vertices()) {
    const auto& p = halfedges.point(v);
    positions.push_back(scale * Vec3(p[0], p[1], p[2]));
  }
  std::vector<std::array<int, 3>> faces;
  for (const auto f : halfedges.faces()) {
    std::array<int, 3> corners;
    std::transform(f.vertices().begin(), f.vertices().end(), corners.begin(),
                   [](const auto& v) { return v.idx(); });
    faces.push_back(corners);
  }
  return make_mesh(std::move(positions), std::move(faces));
}

}  // namespace

Mesh decimate(const Mesh& mesh, int target_faces) {
  if (mesh.face_count() <= target_faces) return mesh;
  HalfedgeMesh halfedges = to_halfedges(mesh);
  halfedges.request_face_normals();
  halfedges.update_face_normals();
  Decimater decimater(halfedges);
  ModBorderQuadric::Handle quadric;
  OpenMesh::Decimater::ModNormalFlippingT<HalfedgeMesh>::Handle flipping;
  decimater.add(quadric);
  decimater.add(flipping);
  decimater.module(quadric).unset_max_err();
  decimater.module(flipping).set_max_normal_deviation(90);
  decimater.initialize();
  decimater.decimate_to_faces(0, static_cast<std::size_t>(target_faces));
  halfedges.garbage_collection();
  Mesh result = from_halfedges(halfedges, mean_edge_length(mesh));
  const std::vector<int> nearest = nearest_faces(result, mesh);
  for (int face = 0; face < result.face_count(); ++face) {
    result.source_faces[face] = mesh.source_faces[nearest[face]];
  }
  return result;
}

}  // namespace foldwright
