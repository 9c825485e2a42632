#include "nets.h"

#include <array>

#include "search/tree_search.h"

namespace foldwright::testing {

Net net_of(const Mesh& mesh, double size) {
  const DualGraph graph = build_dual_graph(mesh);
  TreeSearch search(mesh, graph);
  while (search.step(100000) == TreeSearch::State::kRunning) continue;
  Net net = make_net(mesh, graph, search.best());
  for (Vec2& p : net.vertices) p *= size / 2;
  return net;
}

std::vector<Net> squares_of(const Mesh& cube) {
  const DualGraph graph = build_dual_graph(cube);
  std::vector<Net> nets;
  for (int panel = 0; panel < graph.panel_count(); ++panel) {
    nets.push_back(make_net(cube, restrict_to(graph, std::array{panel}), {}));
    for (Vec2& p : nets.back().vertices) p *= 40;
  }
  return nets;
}

FlapCover triangle_cover(double length, const Vec2& apex) {
  CoverBuilder cover(length);
  cover.add_at_end(0, apex);
  cover.add_at_end(1, apex);
  return cover.take();
}

}  // namespace foldwright::testing
