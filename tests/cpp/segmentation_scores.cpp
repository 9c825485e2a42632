#include "segmentation_scores.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <map>
#include <queue>
#include <utility>

namespace foldwright::testing {
namespace {

double pairs_of(double count) { return count * (count - 1) / 2; }

/// Per vertex whether it lies between faces of different labels.
std::vector<char> cut_vertices(const Mesh& mesh, std::span<const int> labels) {
  std::vector<char> is_cut(mesh.positions.size(), 0);
  for (const Mesh::Edge& edge : mesh.edges) {
    if (edge.faces[1] == -1 || labels[edge.faces[0]] == labels[edge.faces[1]]) continue;
    for (const int v : edge.vertices) is_cut[v] = 1;
  }
  return is_cut;
}

/// Per vertex the length of the shortest path of edges to one of `sources`.
std::vector<double> distances_to(const Mesh& mesh, const std::vector<char>& sources) {
  std::vector<std::vector<int>> edges_at(mesh.positions.size());
  for (int e = 0; e < static_cast<int>(mesh.edges.size()); ++e) {
    for (const int v : mesh.edges[e].vertices) edges_at[v].push_back(e);
  }
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  std::vector<double> best(mesh.positions.size(), std::numeric_limits<double>::infinity());
  for (int v = 0; v < static_cast<int>(best.size()); ++v) {
    if (sources[v]) open.push({best[v] = 0, v});
  }
  while (!open.empty()) {
    const auto [distance, vertex] = open.top();
    open.pop();
    if (distance > best[vertex]) continue;
    for (const int e : edges_at[vertex]) {
      const auto& [a, b] = mesh.edges[e].vertices;
      const int next = a == vertex ? b : a;
      const double longer = distance + (mesh.positions[a] - mesh.positions[b]).norm();
      if (longer >= best[next]) continue;
      best[next] = longer;
      open.push({longer, next});
    }
  }
  return best;
}

double mean_radius(const Mesh& mesh) {
  Vec3 centroid = Vec3::Zero();
  for (const Vec3& p : mesh.positions) centroid += p;
  centroid /= static_cast<double>(mesh.positions.size());
  double sum = 0;
  for (const Vec3& p : mesh.positions) sum += (p - centroid).norm();
  return sum / static_cast<double>(mesh.positions.size());
}

}  // namespace

double rand_index_error(std::span<const int> a, std::span<const int> b) {
  std::map<int, double> in_a, in_b;
  std::map<std::pair<int, int>, double> in_both;
  for (std::size_t face = 0; face < a.size(); ++face) {
    ++in_a[a[face]];
    ++in_b[b[face]];
    ++in_both[{a[face], b[face]}];
  }
  double apart_in_one = 0;
  for (const auto& [label, count] : in_a) apart_in_one += pairs_of(count);
  for (const auto& [label, count] : in_b) apart_in_one += pairs_of(count);
  for (const auto& [labels, count] : in_both) apart_in_one -= 2 * pairs_of(count);
  return a.size() < 2 ? 0 : apart_in_one / pairs_of(static_cast<double>(a.size()));
}

CutDiscrepancy cut_discrepancy(const Mesh& mesh, std::span<const int> a, std::span<const int> b) {
  CutDiscrepancy result;
  const std::vector<char> cuts[2] = {cut_vertices(mesh, a), cut_vertices(mesh, b)};
  for (const int from : {0, 1}) {
    const std::vector<double> distance = distances_to(mesh, cuts[1 - from]);
    double sum = 0;
    int count = 0;
    for (std::size_t v = 0; v < distance.size(); ++v) {
      // Cuts in a component that the other segmentation leaves whole are infinitely far from its.
      if (!cuts[from][v] || distance[v] == std::numeric_limits<double>::infinity()) continue;
      sum += distance[v];
      ++count;
    }
    if (count == 0) return {};
    result.of_cuts += sum / count;
    result.of_vertices += sum / static_cast<double>(mesh.positions.size());
  }
  const double radius = mean_radius(mesh);
  return {result.of_cuts / radius, result.of_vertices / radius, true};
}

double mirror_symmetry(std::span<const int> labels, std::span<const double> areas,
                       std::span<const int> images) {
  std::map<int, std::map<int, double>> landing;  // area by part, and part that it comes to lie on
  double total = 0;
  for (std::size_t panel = 0; panel < labels.size(); ++panel) {
    landing[labels[panel]][labels[images[panel]]] += areas[panel];
    total += areas[panel];
  }
  double mirrored = 0;
  for (const auto& [part, area_on] : landing) {
    double most = 0;
    for (const auto& [other, area] : area_on) most = std::max(most, area);
    mirrored += most;
  }
  return mirrored / total;
}

}  // namespace foldwright::testing
