#include "paper/outline.h"

#include <algorithm>
#include <utility>

namespace foldwright {
namespace {

double signed_area(const Net& net, const std::vector<int>& walk) {
  double twice = 0;
  for (std::size_t i = 0; i < walk.size(); ++i) {
    twice += cross(net.vertices[walk[i]], net.vertices[walk[(i + 1) % walk.size()]]);
  }
  return 0.5 * twice;
}

}  // namespace

std::vector<std::vector<int>> boundary_walks(const Net& net) {
  // A net's vertex stands for one fan of corners, so at most one cut leaves it.
  std::vector<int> next(net.vertices.size(), -1);
  for (const NetEdge& edge : net.edges) {
    if (edge.assignment == Assignment::kCut) next[edge.vertices[0]] = edge.vertices[1];
  }
  std::vector<std::vector<int>> walks;
  for (int start = 0; start < static_cast<int>(next.size()); ++start) {
    if (next[start] == -1) continue;
    std::vector<int> walk;
    for (int v = start; next[v] != -1;) {
      walk.push_back(v);
      v = std::exchange(next[v], -1);
    }
    walks.push_back(std::move(walk));
  }
  const auto outer = std::max_element(walks.begin(), walks.end(), [&](auto& a, auto& b) {
    return signed_area(net, a) < signed_area(net, b);
  });
  if (outer != walks.end()) std::rotate(walks.begin(), outer, outer + 1);
  return walks;
}

}  // namespace foldwright
