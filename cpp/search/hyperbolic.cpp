#include "search/hyperbolic.h"

#include <algorithm>
#include <numbers>

#include "mesh/vertex_turn.h"

namespace foldwright {
namespace {

// Rounding of a few angles; a flat vertex must not count.
constexpr double kAngleSlack = 1e-9;

/// Faces around each vertex, over the whole mesh or over one graph.
std::vector<int> valences(const Mesh& mesh, std::span<const int> faces) {
  std::vector<int> valence(mesh.positions.size(), 0);
  for (const int face : faces) {
    for (const int v : mesh.faces[face]) ++valence[v];
  }
  return valence;
}

}  // namespace

std::vector<char> hyperbolic_vertices(const Mesh& mesh) {
  std::vector<char> hyperbolic;
  for (const double turn : vertex_turns(mesh)) {
    hyperbolic.push_back(turn > 2 * std::numbers::pi + kAngleSlack);
  }
  return hyperbolic;
}

std::vector<std::vector<int>> panel_vertices(const Mesh& mesh, const DualGraph& graph) {
  std::vector<std::vector<int>> vertices(graph.panel_count());
  for (int panel = 0; panel < graph.panel_count(); ++panel) {
    std::vector<int>& corners = vertices[panel];
    for (const int face : graph.panel_faces(panel)) {
      corners.insert(corners.end(), mesh.faces[face].begin(), mesh.faces[face].end());
    }
    std::sort(corners.begin(), corners.end());
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  }
  return vertices;
}

std::vector<std::vector<int>> hyperbolic_vertices_of_panels(const Mesh& mesh,
                                                            const DualGraph& graph) {
  std::vector<int> all(mesh.faces.size());
  for (int face = 0; face < mesh.face_count(); ++face) all[face] = face;
  const std::vector<int> around = valences(mesh, all);
  const std::vector<int> inside = valences(mesh, graph.faces);
  const std::vector<char> hyperbolic = hyperbolic_vertices(mesh);
  std::vector<std::vector<int>> vertices = panel_vertices(mesh, graph);
  for (std::vector<int>& of_panel : vertices) {
    std::erase_if(of_panel, [&](int v) { return !hyperbolic[v] || inside[v] != around[v]; });
  }
  return vertices;
}

}  // namespace foldwright
