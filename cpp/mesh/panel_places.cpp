#include "mesh/panel_places.h"

namespace foldwright {

std::vector<PanelPlace> panel_places(const Mesh& mesh, const DualGraph& graph) {
  std::vector<PanelPlace> places;
  for (int panel = 0; panel < graph.panel_count(); ++panel) {
    Vec3 centroid = Vec3::Zero();
    Vec3 normal = Vec3::Zero();
    for (const int face : graph.panel_faces(panel)) {
      const auto& [i, j, k] = mesh.faces[face];
      const Vec3 &a = mesh.positions[i], &b = mesh.positions[j], &c = mesh.positions[k];
      const Vec3 area = 0.5 * (b - a).cross(c - a);
      centroid += area.norm() / 3 * (a + b + c);
      normal += area;
    }
    places.push_back({centroid / graph.areas[panel], normal.normalized()});
  }
  return places;
}

}  // namespace foldwright
