#include "unfold/layout.h"

#include <algorithm>

#include "geometry/box_pairs.h"

namespace foldwright {

Layout lay_out(const DualGraph& graph, const RootedTree& tree) {
  Layout layout(graph.panel_count());
  for (std::size_t i = 1; i < tree.order.size(); ++i) {
    const int panel = tree.order[i];
    layout[panel] = layout[tree.parent[panel]] * graph.lay_beside(tree.hinge[panel], panel);
  }
  return layout;
}

std::vector<std::array<int, 2>> overlapping_panels(const DualGraph& graph, const Layout& layout) {
  std::vector<Triangle2> triangles(graph.triangles.size());
  std::vector<int> panel_of(graph.triangles.size());
  std::vector<Box2> boxes(graph.triangles.size());
  for (int panel = 0; panel < graph.panel_count(); ++panel) {
    for (int i = graph.first_face[panel]; i < graph.first_face[panel + 1]; ++i) {
      triangles[i] = moved(layout[panel], graph.triangles[i]);
      boxes[i] = box_of(triangles[i]);
      panel_of[i] = panel;
    }
  }
  std::vector<std::array<int, 2>> overlaps;
  const double tolerance = kOverlapTolerance * graph.unit;
  for (const auto& [i, j] : meeting_boxes(boxes)) {
    if (panel_of[i] == panel_of[j]) continue;
    if (!triangles_overlap(triangles[i], triangles[j], tolerance)) continue;
    const auto [low, high] = std::minmax(panel_of[i], panel_of[j]);
    overlaps.push_back({low, high});
  }
  std::sort(overlaps.begin(), overlaps.end());
  overlaps.erase(std::unique(overlaps.begin(), overlaps.end()), overlaps.end());
  return overlaps;
}

}  // namespace foldwright
