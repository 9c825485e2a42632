#include "repair/joints.h"

#include <algorithm>
#include <tuple>

#include "repair/weld.h"

namespace foldwright {
namespace {

// Copies of a vertex lie together but for what making faces flat has moved them, in shares of the
// model's size.
constexpr double kSamePlace = 4e-6;

/// Per vertex the one that stands for all at its place.
std::vector<int> places_of(const Mesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Vec3& p : mesh.positions) box.extend(p);
  const double size = box.sizes().maxCoeff();
  std::vector<Vec3> scaled;
  for (const Vec3& p : mesh.positions) scaled.push_back((p - box.center()) / size);
  return weld(scaled, kSamePlace);
}

/// An edge by the places that it connects; those with two faces before borders.
using Placed = std::tuple<int, int, bool, int>;  // places, is a border, edge

std::vector<Placed> placed_edges(const Mesh& mesh) {
  const std::vector<int> places = places_of(mesh);
  std::vector<Placed> edges;
  for (int e = 0; e < mesh.edge_count(); ++e) {
    const auto& [a, b] = mesh.edges[e].vertices;
    const auto [low, high] = std::minmax(places[a], places[b]);
    edges.emplace_back(low, high, mesh.edges[e].faces[1] == -1, e);
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

}  // namespace

std::vector<Joint> find_joints(const Mesh& mesh) {
  std::vector<Joint> joints;
  const std::vector<Placed> edges = placed_edges(mesh);
  std::size_t host = 0;
  for (std::size_t i = 1; i < edges.size(); ++i) {
    const auto& [low, high, is_border, edge] = edges[i];
    const bool is_beside_host = low == std::get<0>(edges[host]) && high == std::get<1>(edges[host]);
    if (!is_beside_host) {
      host = i;
    } else if (is_border) {
      joints.push_back({edge, std::get<3>(edges[host])});
    }
  }
  std::ranges::sort(joints, {}, &Joint::edge);
  return joints;
}

}  // namespace foldwright
