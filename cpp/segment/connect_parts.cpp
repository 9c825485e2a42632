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

/// How well panels unfold with the settled share of each part: the sum over its panels of area
/// times M [paper, Eq. (1)]. Sums rows first, because many panels of a fine mesh share one.
class CoFoldability {
 public:
  CoFoldability(const DualGraph& graph, const CarriedFoldability& foldability, const Labels& labels,
                const std::vector<char>& settled)
      : foldability_(foldability), weights_(part_count(labels)) {
    for (std::vector<double>& weights : weights_) weights.resize(foldability.matrix.size, 0);
    for (int panel = 0; panel < graph.panel_count(); ++panel) {
      if (settled[panel]) weights_[labels[panel]][foldability.rows[panel]] += graph.areas[panel];
    }
  }

  double operator()(int panel, int part) const {
    const int row = foldability_.rows[panel];
    double sum = 0;
    for (int other = 0; other < foldability_.matrix.size; ++other) {
      sum += weights_[part][other] * foldability_.matrix(row, other);
    }
    return sum;
  }

 private:
  const CarriedFoldability& foldability_;
  std::vector<std::vector<double>> weights_;  ///< area by part and row
};

/// The adjacent settled part that `panel` unfolds best with; -1 when it touches none.
int best_neighbour(const DualGraph& graph, const CoFoldability& co_foldability,
                   const Labels& labels, const std::vector<char>& settled, int panel) {
  std::set<int> adjacent;
  for (const int h : graph.hinges_of(panel)) {
    const int next = graph.hinges[h].other(panel);
    if (settled[next]) adjacent.insert(labels[next]);
  }
  int best = -1;
  double most = -1;
  for (const int part : adjacent) {
    const double value = co_foldability(panel, part);
    if (value > most) most = value, best = part;
  }
  return best;
}

}  // namespace

Labels connect_parts(const DualGraph& graph, const CarriedFoldability& foldability, Labels labels) {
  assert(static_cast<int>(foldability.rows.size()) == graph.panel_count());
  labels = renumbered(labels);
  std::vector<char> settled = in_main_piece(graph, labels);
  const CoFoldability co_foldability(graph, foldability, labels, settled);
  // Stray panels join from the edge of the settled ones inwards, so that what joins is connected.
  for (bool joined = true; joined;) {
    joined = false;
    for (int panel = 0; panel < graph.panel_count(); ++panel) {
      if (settled[panel]) continue;
      const int part = best_neighbour(graph, co_foldability, labels, settled, panel);
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
