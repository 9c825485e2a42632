#include "paper/necks.h"

#include <algorithm>

namespace foldwright {

std::vector<int> find_necks(const DualGraph& graph, std::span<const char> is_fold, double scale) {
  std::vector<int> order = {0};
  std::vector<int> parent_fold(graph.panel_count(), -1);
  std::vector<int> faces_below(graph.panel_count());
  order.reserve(parent_fold.size());
  for (std::size_t head = 0; head < order.size(); ++head) {
    const int panel = order[head];
    faces_below[panel] = static_cast<int>(graph.panel_faces(panel).size());
    for (const int h : graph.hinges_of(panel)) {
      if (!is_fold[h] || h == parent_fold[panel]) continue;
      const int next = graph.hinges[h].other(panel);
      parent_fold[next] = h;
      order.push_back(next);
    }
  }
  const auto faces = static_cast<int>(graph.faces.size());
  std::vector<int> necks;
  for (std::size_t i = order.size() - 1; i > 0; --i) {
    const int panel = order[i];
    const Hinge& fold = graph.hinges[parent_fold[panel]];
    faces_below[fold.other(panel)] += faces_below[panel];
    const int fewer = std::min(faces_below[panel], faces - faces_below[panel]);
    if (fewer >= kNeckFaces && fold.length * scale < kNeckLength) {
      necks.push_back(parent_fold[panel]);
    }
  }
  std::ranges::sort(necks);
  return necks;
}

}  // namespace foldwright
