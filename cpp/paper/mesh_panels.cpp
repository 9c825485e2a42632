#include "paper/mesh_panels.h"

#include <cmath>

#include "geometry/union_find.h"
#include "mesh/dual_graph.h"

namespace foldwright {
MeshPanels::MeshPanels(const Mesh& mesh) : mesh_(&mesh) {
  const int count = static_cast<int>(mesh.faces.size());
  UnionFind joined(count);
  for (int e = 0; e < mesh.edge_count(); ++e) {
    const auto& [face, other] = mesh.edges[e].faces;
    if (other != -1 && std::abs(fold_angle(mesh, e)) < kPanelAngle) joined.join(face, other);
  }
  for (int face = 0; face < count; ++face) panel_of_.push_back(joined.find(face));
  borders_.resize(count);
  for (int face = 0; face < count; ++face) {
    for (int i = 0; i < 3; ++i) {
      const Mesh::Edge& edge = mesh.edges[mesh.face_edges[face][i]];
      const int other = edge.faces[0] == face ? edge.faces[1] : edge.faces[0];
      if (other != -1 && panel_of_[other] == panel_of_[face]) continue;
      borders_[panel_of_[face]].push_back({mesh.faces[face][i], mesh.faces[face][(i + 1) % 3]});
    }
  }
}

FlapCover MeshPanels::beyond(int face, std::array<int, 2> base, double scale) const {
  const Mesh& mesh = *mesh_;
  const Vec3& from = mesh.positions[base[0]];
  const Vec3 along = (mesh.positions[base[1]] - from).normalized();
  const double length = scale * (mesh.positions[base[1]] - from).norm();
  const auto off_base = [&](int vertex) {
    const Vec3 p = mesh.positions[vertex] - from;
    return Vec3(p - along.dot(p) * along);
  };
  // Into the panel goes whatever corner of the face is farthest from the base.
  Vec3 into = Vec3::Zero();
  for (const int vertex : mesh.faces[face]) {
    if (off_base(vertex).squaredNorm() > into.squaredNorm()) into = off_base(vertex);
  }
  into.normalize();
  const auto place = [&](int vertex) {
    const Vec3 p = mesh.positions[vertex] - from;
    return Vec2(scale * Vec2(along.dot(p), into.dot(p)));
  };
  CoverBuilder cover(length);
  for (const auto& [start, end] : borders_[panel_of_[face]]) {
    // The panel is walked around against the base.
    if (start == base[0]) {
      cover.add_at_end(0, place(end));
    } else if (end == base[1]) {
      cover.add_at_end(1, place(start));
    } else {
      cover.add(place(start), place(end));
    }
  }
  return cover.take();
}

}  // namespace foldwright
