#include "segment/min_cut.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace foldwright {
namespace {

// Of the greatest finite capacity: rounding must not keep an augmenting path alive.
constexpr double kRounding = 1e-12;

}  // namespace

MinCut::MinCut(int nodes) : source_(nodes), sink_(nodes + 1), arcs_of_(nodes + 2) {}

void MinCut::add_terminal(int node, double on_sink_side, double on_source_side) {
  if (on_sink_side > 0) add_arcs(source_, node, on_sink_side, 0);
  if (on_source_side > 0) add_arcs(node, sink_, on_source_side, 0);
}

void MinCut::add_link(int a, int b, double cost) { add_arcs(a, b, cost, cost); }

void MinCut::add_arcs(int from, int to, double there, double back) {
  arcs_of_[from].push_back(static_cast<int>(arcs_.size()));
  arcs_.push_back({to, there});
  arcs_of_[to].push_back(static_cast<int>(arcs_.size()));
  arcs_.push_back({from, back});
  for (const double room : {there, back}) {
    if (std::isfinite(room)) least_room_ = std::max(least_room_, kRounding * room);
  }
}

std::vector<char> MinCut::solve() {
  while (find_levels()) {
    next_.assign(arcs_of_.size(), 0);
    while (advance()) {
    }
  }
  std::vector<char> with_source;
  for (int node = 0; node < source_; ++node) with_source.push_back(level_[node] != -1);
  return with_source;
}

/// Distances from the source along arcs with room; false when the sink is out of reach.
bool MinCut::find_levels() {
  level_.assign(arcs_of_.size(), -1);
  level_[source_] = 0;
  std::vector<int> queue = {source_};
  for (std::size_t head = 0; head < queue.size(); ++head) {
    for (const int a : arcs_of_[queue[head]]) {
      const Arc& arc = arcs_[a];
      if (arc.room <= least_room_ || level_[arc.to] != -1) continue;
      level_[arc.to] = level_[queue[head]] + 1;
      queue.push_back(arc.to);
    }
  }
  return level_[sink_] != -1;
}

/// Sends flow along one shortest path; false when there is none left. Without recursion, because
/// paths are as long as a border.
bool MinCut::advance() {
  std::vector<int> path;
  int node = source_;
  while (node != sink_) {
    if (next_[node] == static_cast<int>(arcs_of_[node].size())) {
      if (path.empty()) return false;
      const int last = path.back();
      path.pop_back();
      node = arcs_[last ^ 1].to;
      ++next_[node];
      continue;
    }
    const int a = arcs_of_[node][next_[node]];
    if (arcs_[a].room > least_room_ && level_[arcs_[a].to] == level_[node] + 1) {
      path.push_back(a);
      node = arcs_[a].to;
    } else {
      ++next_[node];
    }
  }
  double flow = std::numeric_limits<double>::infinity();
  for (const int a : path) flow = std::min(flow, arcs_[a].room);
  for (const int a : path) {
    arcs_[a].room -= flow;
    arcs_[a ^ 1].room += flow;
  }
  return true;
}

}  // namespace foldwright
