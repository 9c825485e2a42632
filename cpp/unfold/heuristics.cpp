#include "unfold/heuristics.h"

#include <cmath>
#include <map>

namespace foldwright {
namespace {

/// Hinge edges around one vertex, and whether the graph ends at it.
struct Star {
  std::vector<int> hinges;
  std::vector<Vec3> directions;
  bool on_border = false;
};

/// Stars of all vertices of the graph's faces, by vertex.
std::map<int, Star> vertex_stars(const Mesh& mesh, const DualGraph& graph) {
  std::vector<int> panel_of(mesh.faces.size(), -1);
  for (int panel = 0; panel < graph.panel_count(); ++panel) {
    for (const int face : graph.panel_faces(panel)) panel_of[face] = panel;
  }
  std::map<int, Star> stars;
  for (const int face : graph.faces) {
    for (const int e : mesh.face_edges[face]) {
      const Mesh::Edge& edge = mesh.edges[e];
      const int next = edge.faces[0] == face ? edge.faces[1] : edge.faces[0];
      if (next != -1 && panel_of[next] != -1) continue;
      for (const int v : edge.vertices) stars[v].on_border = true;
    }
  }
  for (int h = 0; h < graph.hinge_count(); ++h) {
    for (const int e : graph.hinges[h].edges) {
      const auto& [a, b] = mesh.edges[e].vertices;
      const Vec3 along = (mesh.positions[b] - mesh.positions[a]).normalized();
      stars[a].hinges.push_back(h);
      stars[a].directions.push_back(along);
      stars[b].hinges.push_back(h);
      stars[b].directions.push_back(-along);
    }
  }
  return stars;
}

}  // namespace

HeuristicWeights::HeuristicWeights(const Mesh& mesh, const DualGraph& graph) : graph_(&graph) {
  for (const Hinge& hinge : graph.hinges) {
    const auto& [a, b] = mesh.edges[hinge.edges[0]].vertices;
    hinge_directions_.push_back((mesh.positions[b] - mesh.positions[a]).normalized());
  }
  for (const auto& [vertex, star] : vertex_stars(mesh, graph)) {
    // In the middle of a hinge of several edges nothing needs a cut: the surface is flat there.
    const bool mid_hinge = star.hinges.size() == 2 && star.hinges[0] == star.hinges[1];
    if (star.on_border || star.hinges.empty() || mid_hinge) continue;
    for (std::size_t i = 0; i < star.hinges.size(); ++i) {
      spokes_.push_back({star.hinges[i], star.directions[i]});
    }
    first_spoke_.push_back(static_cast<int>(spokes_.size()));
    positions_.push_back(mesh.positions[vertex]);
  }
}

std::vector<double> HeuristicWeights::flat_tree(const Vec3& direction) const {
  std::vector<double> weights;
  weights.reserve(hinge_directions_.size());
  for (const Vec3& along : hinge_directions_) weights.push_back(std::abs(along.dot(direction)));
  return weights;
}

std::vector<double> HeuristicWeights::steepest_edge(const Vec3& direction) const {
  std::vector<double> weights = flat_tree(direction);
  // The flatness only orders hinges within the folds and within the cuts: it stays below 1.
  for (double& weight : weights) weight *= 0.5;
  int top = 0;
  for (std::size_t v = 1; v < positions_.size(); ++v) {
    if (positions_[v].dot(direction) > positions_[top].dot(direction)) top = static_cast<int>(v);
  }
  for (int v = 0; v < static_cast<int>(positions_.size()); ++v) {
    if (v == top) continue;
    int steepest = first_spoke_[v];
    for (int s = steepest + 1; s < first_spoke_[v + 1]; ++s) {
      if (spokes_[s].direction.dot(direction) > spokes_[steepest].direction.dot(direction)) {
        steepest = s;
      }
    }
    double& weight = weights[spokes_[steepest].hinge];
    if (weight < 1) weight += 1;
  }
  return weights;
}

std::vector<double> HeuristicWeights::weights(Heuristic heuristic, const Vec3& direction, int run,
                                              Random& random) const {
  switch (heuristic) {
    case Heuristic::kSteepestEdge:
      return steepest_edge(direction);
    case Heuristic::kFlatTree:
      return flat_tree(direction);
    case Heuristic::kHybrid:
      return run % 2 == 0 ? steepest_edge(direction) : flat_tree(direction);
    case Heuristic::kRandom:
      break;
  }
  std::vector<double> weights(graph_->hinge_count());
  for (double& weight : weights) weight = random.uniform();
  return weights;
}

}  // namespace foldwright
