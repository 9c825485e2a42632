#include "segment/concave_geodesic.h"

#include <cmath>
#include <functional>
#include <queue>
#include <utility>

namespace foldwright {
namespace {

constexpr double kConvexWeight = 0.05;  // eta of a convex hinge: nearly free
constexpr double kBendShare = 0.9;      // of the bend in a hinge's length; the rest is distance
constexpr float kUnreachable = 1e3f;    // in mean distances: its affinity vanishes

std::vector<Vec3> panel_centroids(const Mesh& mesh, const DualGraph& graph) {
  std::vector<Vec3> centroids;
  for (int panel = 0; panel < graph.panel_count(); ++panel) {
    Vec3 sum = Vec3::Zero();
    for (const int face : graph.panel_faces(panel)) {
      const auto& [a, b, c] = mesh.faces[face];
      sum +=
          face_area(mesh, face) / 3 * (mesh.positions[a] + mesh.positions[b] + mesh.positions[c]);
    }
    centroids.push_back(sum / graph.areas[panel]);
  }
  return centroids;
}

Vec3 midpoint(const Mesh& mesh, const Hinge& hinge) {
  Vec3 sum = Vec3::Zero();
  for (const int e : hinge.edges) {
    for (const int v : mesh.edges[e].vertices) sum += mesh.positions[v];
  }
  return sum / (2.0 * static_cast<double>(hinge.edges.size()));
}

/// Length of every hinge: relative distance and relative bend, mixed.
std::vector<double> hinge_lengths(const Mesh& mesh, const DualGraph& graph) {
  const std::vector<Vec3> centroids = panel_centroids(mesh, graph);
  std::vector<double> distance, bend;
  double distance_sum = 0;
  double bend_sum = 0;
  for (const Hinge& hinge : graph.hinges) {
    const Vec3 middle = midpoint(mesh, hinge);
    distance.push_back((centroids[hinge.panels[0]] - middle).norm() +
                       (centroids[hinge.panels[1]] - middle).norm());
    bend.push_back((hinge.angle > 0 ? 1 : kConvexWeight) * (1 - std::cos(hinge.angle)));
    distance_sum += distance.back();
    bend_sum += bend.back();
  }
  const auto count = static_cast<double>(graph.hinge_count());
  const double distance_scale = (1 - kBendShare) * count / distance_sum;
  const double bend_scale = bend_sum > 0 ? kBendShare * count / bend_sum : 0;
  for (std::size_t h = 0; h < distance.size(); ++h) {
    distance[h] = distance_scale * distance[h] + bend_scale * bend[h];
  }
  return distance;
}

/// Dijkstra's algorithm from one panel; -1 where it does not reach.
void distances_from(const DualGraph& graph, const std::vector<double>& lengths, int source,
                    std::span<float> row) {
  using Entry = std::pair<double, int>;  // ordered by distance, then panel
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  std::vector<double> best(graph.panel_count(), -1);
  best[source] = 0;
  open.push({0, source});
  while (!open.empty()) {
    const auto [distance, panel] = open.top();
    open.pop();
    if (distance > best[panel]) continue;
    for (const int h : graph.hinges_of(panel)) {
      const int next = graph.hinges[h].other(panel);
      const double longer = distance + lengths[h];
      if (best[next] >= 0 && best[next] <= longer) continue;
      best[next] = longer;
      open.push({longer, next});
    }
  }
  for (std::size_t i = 0; i < best.size(); ++i) row[i] = static_cast<float>(best[i]);
}

}  // namespace

std::vector<float> concave_geodesic(const Mesh& mesh, const DualGraph& graph) {
  const auto n = static_cast<std::size_t>(graph.panel_count());
  std::vector<float> distances(n * n, 0);
  if (n == 1) return distances;
  const std::vector<double> lengths = hinge_lengths(mesh, graph);
  double sum = 0;
  std::size_t reached = 0;
  for (std::size_t source = 0; source < n; ++source) {
    const std::span<float> row(&distances[source * n], n);
    distances_from(graph, lengths, static_cast<int>(source), row);
    for (const float distance : row) {
      if (distance < 0) continue;
      sum += distance;
      ++reached;
    }
  }
  // Where no panel reaches another there is nothing to scale.
  const auto scale = sum > 0 ? static_cast<float>(static_cast<double>(reached) / sum) : 1.0f;
  for (float& distance : distances) distance = distance < 0 ? kUnreachable : distance * scale;
  return distances;
}

}  // namespace foldwright
