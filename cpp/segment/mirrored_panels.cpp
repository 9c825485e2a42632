#include "segment/mirrored_panels.h"

#include <utility>

#include "mesh/nearest_face.h"

namespace foldwright {

std::vector<int> mirrored_panels(const Mesh& mesh, const DualGraph& graph, const Mirror& mirror) {
  const Mesh own = submesh(mesh, graph.faces);
  std::vector<Vec3> positions;
  for (const Vec3& p : own.positions) positions.push_back(mirror.image(p));
  auto faces = own.faces;
  for (auto& face : faces) std::swap(face[1], face[2]);
  const std::vector<int> nearest = nearest_faces(make_mesh(std::move(positions), faces), own);
  std::vector<int> panel_of;  // of each of the graph's faces, in their order
  for (int panel = 0; panel < graph.panel_count(); ++panel) {
    panel_of.resize(graph.first_face[panel + 1], panel);
  }
  std::vector<int> images;
  std::vector<double> area(graph.panel_count(), 0);
  for (int panel = 0; panel < graph.panel_count(); ++panel) {
    int best = panel_of[nearest[graph.first_face[panel]]];
    for (int i = graph.first_face[panel]; i < graph.first_face[panel + 1]; ++i) {
      const int image = panel_of[nearest[i]];
      area[image] += face_area(own, i);
      if (area[image] > area[best]) best = image;
    }
    for (int i = graph.first_face[panel]; i < graph.first_face[panel + 1]; ++i) {
      area[panel_of[nearest[i]]] = 0;
    }
    images.push_back(best);
  }
  return images;
}

}  // namespace foldwright
