#include "mesh/connectivity.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace foldwright {

bool is_connected(const DualGraph& graph) {
  if (graph.panel_count() == 0) return false;
  std::vector<char> seen(graph.panel_count(), 0);
  std::vector<int> queue = {0};
  seen[0] = 1;
  for (std::size_t head = 0; head < queue.size(); ++head) {
    for (const int h : graph.hinges_of(queue[head])) {
      const int next = graph.hinges[h].other(queue[head]);
      if (!std::exchange(seen[next], 1)) queue.push_back(next);
    }
  }
  return static_cast<int>(queue.size()) == graph.panel_count();
}

bool stays_connected(const DualGraph& graph, std::span<const int> labels, int panel) {
  // All that the panel can keep together are its neighbours in the part.
  std::vector<int> targets;
  for (const int h : graph.hinges_of(panel)) {
    const int next = graph.hinges[h].other(panel);
    if (labels[next] == labels[panel]) targets.push_back(next);
  }
  if (targets.empty()) return false;
  std::vector<char> seen(graph.panel_count(), 0);
  seen[panel] = seen[targets[0]] = 1;
  std::vector<int> queue = {targets[0]};
  for (std::size_t head = 0; head < queue.size(); ++head) {
    for (const int h : graph.hinges_of(queue[head])) {
      const int next = graph.hinges[h].other(queue[head]);
      if (seen[next] || labels[next] != labels[panel]) continue;
      seen[next] = 1;
      queue.push_back(next);
    }
  }
  return std::ranges::all_of(targets, [&](int target) { return seen[target] != 0; });
}

}  // namespace foldwright
