#include "segment/curvature_pockets.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "mesh/connectivity.h"
#include "mesh/vertex_turn.h"

namespace foldwright {
namespace {

// A pocket has more than this multiple of its positive curvature as negative: none of 200 parts
// above it had a net, most below it had.
constexpr double kMostNegative = 5;

// Rounding of the angles around a vertex.
constexpr double kFlat = 1e-9;

// The gain that an exchange must bring, in radians: far above rounding.
constexpr double kLeastGain = 1e-7;

/// Curvature and neighbourhood of the vertices, and floods over those inside a part.
class Pockets {
 public:
  Pockets(const Mesh& mesh, const DualGraph& graph);

  /// Deficit of the pockets that hold one of `seeds`, each pocket once.
  double deficit(const Labels& labels, std::span<const int> seeds);
  /// Inner vertices of pockets, each pocket's together.
  std::vector<std::vector<int>> all(const Labels& labels);

  std::span<const int> panels_at(int vertex) const {
    return std::span(panels_).subspan(first_panel_[vertex],
                                      first_panel_[vertex + 1] - first_panel_[vertex]);
  }
  /// Vertices of a panel and those one edge away.
  std::vector<int> around(int panel) const;

 private:
  bool is_inside(int vertex, const Labels& labels) const;
  /// Deficit of the inner vertices that hang together with `seed`, left in `flood_`.
  double flood(int seed, const Labels& labels);
  std::span<const int> neighbours(int vertex) const {
    return std::span(neighbours_)
        .subspan(first_neighbour_[vertex], first_neighbour_[vertex + 1] - first_neighbour_[vertex]);
  }
  void find_border();
  void find_neighbours();
  void find_panels();

  const Mesh& mesh_;
  const DualGraph& graph_;
  std::vector<double> curvature_;
  std::vector<char> on_border_;                    ///< per vertex: of the graph
  std::vector<int> first_neighbour_, neighbours_;  ///< CSR over vertices, along hinges
  std::vector<int> first_panel_, panels_;          ///< CSR over vertices
  std::vector<std::vector<int>> corners_;          ///< per panel
  std::vector<int> seen_;
  int stamp_ = 0;
  std::vector<int> flood_;
};

Pockets::Pockets(const Mesh& mesh, const DualGraph& graph)
    : mesh_(mesh),
      graph_(graph),
      curvature_(vertex_turns(mesh, graph.faces)),
      on_border_(mesh.positions.size(), 0),
      corners_(graph.panel_count()),
      seen_(mesh.positions.size(), 0) {
  for (double& turn : curvature_) turn = 2 * std::numbers::pi - turn;
  find_border();
  find_neighbours();
  find_panels();
}

void Pockets::find_border() {
  std::vector<char> is_inside(mesh_.faces.size(), 0);
  for (const int face : graph_.faces) is_inside[face] = 1;
  for (const int face : graph_.faces) {
    for (const int e : mesh_.face_edges[face]) {
      const Mesh::Edge& edge = mesh_.edges[e];
      if (edge.faces[1] != -1 && is_inside[edge.faces[0]] && is_inside[edge.faces[1]]) continue;
      for (const int v : edge.vertices) on_border_[v] = 1;
    }
  }
}

void Pockets::find_neighbours() {
  first_neighbour_.assign(mesh_.positions.size() + 1, 0);
  const auto for_edges = [&](auto&& visit) {
    for (const Hinge& hinge : graph_.hinges) {
      for (const int e : hinge.edges) visit(mesh_.edges[e].vertices);
    }
  };
  for_edges([&](const std::array<int, 2>& ends) {
    for (const int v : ends) ++first_neighbour_[v + 1];
  });
  for (std::size_t v = 1; v < first_neighbour_.size(); ++v) {
    first_neighbour_[v] += first_neighbour_[v - 1];
  }
  neighbours_.resize(first_neighbour_.back());
  std::vector<int> next(first_neighbour_.begin(), first_neighbour_.end() - 1);
  for_edges([&](const std::array<int, 2>& ends) {
    for (const int side : {0, 1}) neighbours_[next[ends[side]]++] = ends[1 - side];
  });
}

void Pockets::find_panels() {
  std::vector<std::vector<int>> panels(mesh_.positions.size());
  for (int panel = 0; panel < graph_.panel_count(); ++panel) {
    for (const int face : graph_.panel_faces(panel)) {
      for (const int v : mesh_.faces[face]) {
        if (!panels[v].empty() && panels[v].back() == panel) continue;
        panels[v].push_back(panel);
        corners_[panel].push_back(v);
      }
    }
  }
  first_panel_ = {0};
  for (const std::vector<int>& of_vertex : panels) {
    panels_.insert(panels_.end(), of_vertex.begin(), of_vertex.end());
    first_panel_.push_back(static_cast<int>(panels_.size()));
  }
}

bool Pockets::is_inside(int vertex, const Labels& labels) const {
  const auto panels = panels_at(vertex);
  if (panels.empty() || on_border_[vertex]) return false;
  return std::all_of(panels.begin(), panels.end(),
                     [&](int panel) { return labels[panel] == labels[panels[0]]; });
}

double Pockets::flood(int seed, const Labels& labels) {
  flood_.assign(1, seed);
  seen_[seed] = stamp_;
  double positive = 0;
  double negative = 0;
  for (std::size_t head = 0; head < flood_.size(); ++head) {
    const int v = flood_[head];
    (curvature_[v] > 0 ? positive : negative) += std::abs(curvature_[v]);
    for (const int next : neighbours(v)) {
      if (seen_[next] == stamp_ || !is_inside(next, labels)) continue;
      seen_[next] = stamp_;
      flood_.push_back(next);
    }
  }
  const double slack = kFlat * static_cast<double>(flood_.size());
  const double deficit = negative - kMostNegative * positive;
  return deficit > slack ? deficit : 0;
}

double Pockets::deficit(const Labels& labels, std::span<const int> seeds) {
  ++stamp_;
  double sum = 0;
  for (const int v : seeds) {
    if (seen_[v] != stamp_ && is_inside(v, labels)) sum += flood(v, labels);
  }
  return sum;
}

std::vector<std::vector<int>> Pockets::all(const Labels& labels) {
  ++stamp_;
  std::vector<std::vector<int>> pockets;
  for (int v = 0; v < mesh_.vertex_count(); ++v) {
    if (seen_[v] == stamp_ || !is_inside(v, labels)) continue;
    if (flood(v, labels) > 0) pockets.push_back(flood_);
  }
  return pockets;
}

std::vector<int> Pockets::around(int panel) const {
  std::vector<int> vertices = corners_[panel];
  for (const int corner : corners_[panel]) {
    for (const int v : neighbours(corner)) vertices.push_back(v);
  }
  return vertices;
}

/// A panel and the part that it would go to.
struct Exchange {
  int panel, to;
  auto operator<=>(const Exchange&) const = default;
};

/// Exchanges of panels over the border that touch a pocket or its surroundings.
std::vector<Exchange> exchanges_near(const Pockets& pockets, const DualGraph& graph,
                                     const Labels& labels, std::span<const int> pocket) {
  std::vector<Exchange> exchanges;
  for (const int v : pocket) {
    for (const int panel : pockets.panels_at(v)) {
      for (const int h : graph.hinges_of(panel)) {
        const int next = graph.hinges[h].other(panel);
        if (labels[next] == labels[panel]) continue;
        exchanges.push_back({panel, labels[next]});
        exchanges.push_back({next, labels[panel]});
      }
    }
  }
  std::sort(exchanges.begin(), exchanges.end());
  exchanges.erase(std::unique(exchanges.begin(), exchanges.end()), exchanges.end());
  return exchanges;
}

/// Makes the exchange near a pocket that lessens the deficit most; false when none does.
bool open_pocket(Pockets& pockets, const DualGraph& graph, Labels& labels,
                 std::span<const int> pocket) {
  Exchange best{-1, -1};
  double best_gain = kLeastGain;
  for (const Exchange& exchange : exchanges_near(pockets, graph, labels, pocket)) {
    const std::vector<int> seeds = pockets.around(exchange.panel);
    const double before = pockets.deficit(labels, seeds);
    const int from = std::exchange(labels[exchange.panel], exchange.to);
    const double gain = before - pockets.deficit(labels, seeds);
    labels[exchange.panel] = from;
    if (gain <= best_gain || !stays_connected(graph, labels, exchange.panel)) continue;
    best_gain = gain;
    best = exchange;
  }
  if (best.panel == -1) return false;
  labels[best.panel] = best.to;
  return true;
}

}  // namespace

double pocket_deficit(const Mesh& mesh, const DualGraph& graph, const Labels& labels) {
  std::vector<int> all(mesh.positions.size());
  for (std::size_t v = 0; v < all.size(); ++v) all[v] = static_cast<int>(v);
  return Pockets(mesh, graph).deficit(labels, all);
}

Labels open_pockets(const Mesh& mesh, const DualGraph& graph, Labels labels) {
  Pockets pockets(mesh, graph);
  // Each round opens every pocket it can; the deficit falls with each exchange, so it ends.
  for (bool changed = true; changed;) {
    changed = false;
    for (const std::vector<int>& pocket : pockets.all(labels)) {
      changed |= open_pocket(pockets, graph, labels, pocket);
    }
  }
  return labels;
}

}  // namespace foldwright
