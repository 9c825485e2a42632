#include "segment/labels.h"

#include <algorithm>

namespace foldwright {

Labels renumbered(std::span<const int> labels) {
  Labels result;
  std::vector<int> number;
  int count = 0;
  for (const int label : labels) {
    if (label >= static_cast<int>(number.size())) number.resize(label + 1, -1);
    if (number[label] == -1) number[label] = count++;
    result.push_back(number[label]);
  }
  return result;
}

int part_count(std::span<const int> labels) {
  return labels.empty() ? 0 : 1 + *std::max_element(labels.begin(), labels.end());
}

std::vector<double> part_areas(const DualGraph& graph, std::span<const int> labels) {
  std::vector<double> areas(part_count(labels), 0);
  for (int panel = 0; panel < graph.panel_count(); ++panel) {
    areas[labels[panel]] += graph.areas[panel];
  }
  return areas;
}

std::vector<int> panels_of(std::span<const int> labels, int part) {
  std::vector<int> panels;
  for (int panel = 0; panel < static_cast<int>(labels.size()); ++panel) {
    if (labels[panel] == part) panels.push_back(panel);
  }
  return panels;
}

std::vector<int> part_pieces(const DualGraph& graph, std::span<const int> labels) {
  std::vector<int> piece(graph.panel_count(), -1);
  std::vector<int> stack;
  int count = 0;
  for (int seed = 0; seed < graph.panel_count(); ++seed) {
    if (piece[seed] != -1) continue;
    piece[seed] = count;
    stack.assign(1, seed);
    while (!stack.empty()) {
      const int panel = stack.back();
      stack.pop_back();
      for (const int h : graph.hinges_of(panel)) {
        const int next = graph.hinges[h].other(panel);
        if (piece[next] != -1 || labels[next] != labels[panel]) continue;
        piece[next] = count;
        stack.push_back(next);
      }
    }
    ++count;
  }
  return piece;
}

}  // namespace foldwright
