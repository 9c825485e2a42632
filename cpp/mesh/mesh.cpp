#include "mesh/mesh.h"

#include <cassert>
#include <cstdint>
#include <unordered_map>
#include <utility>

namespace foldwright {
namespace {

void build_edges(Mesh& mesh) {
  std::unordered_map<std::uint64_t, int> edge_of;  // looked up only, never iterated
  edge_of.reserve(mesh.faces.size() * 2);
  mesh.face_edges.resize(mesh.faces.size());
  for (int f = 0; f < mesh.face_count(); ++f) {
    for (int i = 0; i < 3; ++i) {
      const int a = mesh.faces[f][i];
      const int b = mesh.faces[f][(i + 1) % 3];
      const auto [low, high] = std::minmax(a, b);
      const std::uint64_t key =
          (static_cast<std::uint64_t>(low) << 32) | static_cast<unsigned>(high);
      const auto [entry, is_new] = edge_of.try_emplace(key, mesh.edge_count());
      if (is_new) {
        mesh.edges.push_back({{a, b}, {f, -1}});
      } else {
        Mesh::Edge& edge = mesh.edges[entry->second];
        assert(edge.faces[1] == -1 && edge.vertices[0] == b && "edge is not manifold and oriented");
        edge.faces[1] = f;
      }
      mesh.face_edges[f][i] = entry->second;
    }
  }
}

void build_components(Mesh& mesh) {
  mesh.components.assign(mesh.faces.size(), -1);
  std::vector<int> stack;
  for (int seed = 0; seed < mesh.face_count(); ++seed) {
    if (mesh.components[seed] != -1) continue;
    stack.assign(1, seed);
    mesh.components[seed] = mesh.component_count;
    while (!stack.empty()) {
      const int face = stack.back();
      stack.pop_back();
      for (const int e : mesh.face_edges[face]) {
        for (const int next : mesh.edges[e].faces) {
          if (next == -1 || mesh.components[next] != -1) continue;
          mesh.components[next] = mesh.component_count;
          stack.push_back(next);
        }
      }
    }
    ++mesh.component_count;
  }
}

}  // namespace

Mesh make_mesh(std::vector<Vec3> positions, std::vector<std::array<int, 3>> faces,
               std::vector<int> source_faces) {
  Mesh mesh;
  mesh.positions = std::move(positions);
  mesh.faces = std::move(faces);
  mesh.source_faces = std::move(source_faces);
  if (mesh.source_faces.empty()) {
    for (int f = 0; f < mesh.face_count(); ++f) mesh.source_faces.push_back(f);
  }
  assert(mesh.source_faces.size() == mesh.faces.size());
  build_edges(mesh);
  build_components(mesh);
  return mesh;
}

Mesh submesh(const Mesh& mesh, std::span<const int> faces) {
  std::vector<int> new_index(mesh.positions.size(), -1);
  std::vector<Vec3> positions;
  std::vector<std::array<int, 3>> kept;
  std::vector<int> source_faces;
  for (const int face : faces) {
    std::array<int, 3> corners = mesh.faces[face];
    for (int& v : corners) {
      if (new_index[v] == -1) {
        new_index[v] = static_cast<int>(positions.size());
        positions.push_back(mesh.positions[v]);
      }
      v = new_index[v];
    }
    kept.push_back(corners);
    source_faces.push_back(mesh.source_faces[face]);
  }
  return make_mesh(std::move(positions), std::move(kept), std::move(source_faces));
}

double face_area(const Mesh& mesh, int face) {
  const auto& [a, b, c] = mesh.faces[face];
  const Vec3 ab = mesh.positions[b] - mesh.positions[a];
  const Vec3 ac = mesh.positions[c] - mesh.positions[a];
  return 0.5 * ab.cross(ac).norm();
}

double mean_edge_length(const Mesh& mesh) {
  double sum = 0;
  for (const Mesh::Edge& edge : mesh.edges) {
    sum += (mesh.positions[edge.vertices[0]] - mesh.positions[edge.vertices[1]]).norm();
  }
  return mesh.edges.empty() ? 0 : sum / mesh.edge_count();
}

}  // namespace foldwright
