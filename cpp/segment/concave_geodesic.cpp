#include "segment/concave_geodesic.h"

#include <cmath>
#include <numeric>

#include "segment/hinge_measures.h"

namespace foldwright {
namespace {

constexpr double kConvexWeight = 0.05;  // eta of a convex hinge: nearly free
constexpr double kBendShare = 0.9;      // of the bend in a hinge's length; the rest is distance
constexpr float kUnreachable = 1e3f;    // in mean distances: its affinity vanishes

/// Length of every hinge: relative distance and relative bend, mixed.
std::vector<double> hinge_lengths(const Mesh& mesh, const DualGraph& graph) {
  std::vector<double> lengths = hinge_distances(mesh, graph);
  const std::vector<double> bends = hinge_bends(graph, kConvexWeight);
  const double sum = std::accumulate(lengths.begin(), lengths.end(), 0.0);
  const double scale = (1 - kBendShare) * static_cast<double>(graph.hinge_count()) / sum;
  for (std::size_t h = 0; h < lengths.size(); ++h) {
    lengths[h] = scale * lengths[h] + kBendShare * bends[h];
  }
  return lengths;
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
    const std::vector<double> row = distances_from(graph, lengths, static_cast<int>(source));
    for (std::size_t i = 0; i < n; ++i) {
      distances[source * n + i] = static_cast<float>(row[i]);
      if (std::isinf(row[i])) continue;
      sum += row[i];
      ++reached;
    }
  }
  // Where no panel reaches another there is nothing to scale.
  const auto scale = sum > 0 ? static_cast<float>(static_cast<double>(reached) / sum) : 1.0f;
  for (float& distance : distances) {
    distance = std::isinf(distance) ? kUnreachable : distance * scale;
  }
  return distances;
}

}  // namespace foldwright
