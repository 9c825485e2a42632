#include "segment/connect_parts.h"

#include <cassert>
#include <set>

namespace foldwright {
namespace {

/// Whether each panel belongs to the largest piece of its part.
std::vector<char> in_main_piece(const DualGraph& graph, const Labels& labels) {
  const std::vector<int> piece = part_pieces(graph, labels);
  std::vector<double> area(part_count(piece), 0);
  for (int panel = 0; panel < graph.panel_count(); ++panel)
    area[piece[panel]] += graph.areas[panel];
  std::vector<int> main(part_count(labels), -1);
  for (int panel = 0; panel < graph.panel_count(); ++panel) {
    int& largest = main[labels[panel]];
    if (largest == -1 || area[piece[panel]] > area[largest]) largest = piece[panel];
  }
  std::vector<char> result;
  for (int panel = 0; panel < graph.panel_count(); ++panel) {
    result.push_back(piece[panel] == main[labels[panel]]);
  }
  return result;
}

double co_foldability(const DualGraph& graph, const CarriedFoldability& foldability,
                      const Labels& labels, const std::vector<char>& settled, int panel, int part) {
  double sum = 0;
  for (int other = 0; other < graph.panel_count(); ++other) {
    if (settled[other] && labels[other] == part)
      sum += graph.areas[other] * foldability(panel, other);
  }
  return sum;
}

/// The adjacent settled part that `panel` unfolds best with; -1 when it touches none.
int best_neighbour(const DualGraph& graph, const CarriedFoldability& foldability,
                   const Labels& labels, const std::vector<char>& settled, int panel) {
  std::set<int> adjacent;
  for (const int h : graph.hinges_of(panel)) {
    const int next = graph.hinges[h].other(panel);
    if (settled[next]) adjacent.insert(labels[next]);
  }
  int best = -1;
  double most = -1;
  for (const int part : adjacent) {
    const double value = co_foldability(graph, foldability, labels, settled, panel, part);
    if (value > most) most = value, best = part;
  }
  return best;
}

}  // namespace

Labels connect_parts(const DualGraph& graph, const CarriedFoldability& foldability, Labels labels) {
  assert(static_cast<int>(foldability.rows.size()) == graph.panel_count());
  labels = renumbered(labels);
  std::vector<char> settled = in_main_piece(graph, labels);
  // Stray panels join from the edge of the settled ones inwards, so that what joins is connected.
  for (bool joined = true; joined;) {
    joined = false;
    for (int panel = 0; panel < graph.panel_count(); ++panel) {
      if (settled[panel]) continue;
      const int part = best_neighbour(graph, foldability, labels, settled, panel);
      if (part == -1) continue;
      labels[panel] = part;
      settled[panel] = 1;
      joined = true;
    }
  }
  // What is left lies in components of the mesh without a settled panel: each is its own part.
  const std::vector<int> piece = part_pieces(graph, labels);
  const int parts = part_count(labels);
  for (int panel = 0; panel < graph.panel_count(); ++panel) {
    if (!settled[panel]) labels[panel] = parts + piece[panel];
  }
  return renumbered(labels);
}

}  // namespace foldwright
