#include "segment/hinge_measures.h"

#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <queue>
#include <utility>

namespace foldwright {
namespace {

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

}  // namespace

std::vector<double> hinge_distances(const Mesh& mesh, const DualGraph& graph) {
  const std::vector<Vec3> centroids = panel_centroids(mesh, graph);
  std::vector<double> distances;
  for (const Hinge& hinge : graph.hinges) {
    const Vec3 middle = midpoint(mesh, hinge);
    distances.push_back((centroids[hinge.panels[0]] - middle).norm() +
                        (centroids[hinge.panels[1]] - middle).norm());
  }
  return distances;
}

std::vector<double> hinge_bends(const DualGraph& graph, double convex) {
  std::vector<double> bends;
  for (const Hinge& hinge : graph.hinges) {
    bends.push_back((hinge.angle > 0 ? 1 : convex) * (1 - std::cos(hinge.angle)));
  }
  const double sum = std::accumulate(bends.begin(), bends.end(), 0.0);
  if (sum == 0) return bends;
  for (double& bend : bends) bend *= static_cast<double>(bends.size()) / sum;
  return bends;
}

std::vector<double> distances_from(const DualGraph& graph, std::span<const double> lengths,
                                   int source) {
  using Entry = std::pair<double, int>;  // ordered by distance, then panel
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  std::vector<double> best(graph.panel_count(), std::numeric_limits<double>::infinity());
  best[source] = 0;
  open.push({0, source});
  while (!open.empty()) {
    const auto [distance, panel] = open.top();
    open.pop();
    if (distance > best[panel]) continue;
    for (const int h : graph.hinges_of(panel)) {
      const int next = graph.hinges[h].other(panel);
      const double longer = distance + lengths[h];
      if (best[next] <= longer) continue;
      best[next] = longer;
      open.push({longer, next});
    }
  }
  return best;
}

}  // namespace foldwright
