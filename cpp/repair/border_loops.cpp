#include "repair/border_loops.h"

#include <algorithm>
#include <map>
#include <utility>

#include "repair/edge_groups.h"

namespace foldwright {
namespace {

/// Walks along border edges, each of them once, and takes off a loop whenever it comes to a vertex
/// that it has passed.
class BorderWalk {
 public:
  explicit BorderWalk(const TriangleSoup& soup) : soup_(soup) {
    for (const int h : border_half_edges(soup)) {
      unused_[start_vertex(soup, h)].push_back(h);
      unused_[end_vertex(soup, h)].push_back(h);
    }
  }

  std::vector<BorderLoop> loops() {
    for (const auto& [vertex, half_edges] : unused_) walk_from(vertex);
    return std::move(loops_);
  }

 private:
  const TriangleSoup& soup_;
  std::map<int, std::vector<int>> unused_;  ///< per vertex: half-edges at it, ascending
  BorderLoop path_;                         ///< from each of its vertices the edge that was taken
  std::map<int, int> step_of_;              ///< per vertex of the path: where it is in it
  std::vector<BorderLoop> loops_;

  void walk_from(int vertex) {
    for (;;) {
      const int half_edge = take_edge(vertex);
      if (half_edge == -1) {
        if (path_.vertices.empty()) return;
        vertex = step_back();
        continue;
      }
      step_of_[vertex] = static_cast<int>(path_.vertices.size());
      path_.vertices.push_back(vertex);
      path_.half_edges.push_back(half_edge);
      vertex = start_vertex(soup_, half_edge) + end_vertex(soup_, half_edge) - vertex;
      if (step_of_.contains(vertex)) take_loop(step_of_[vertex]);
    }
  }

  /// An edge to go on, preferably against its face: at a vertex of several loops that is one of
  /// theirs. -1 if there is none.
  int take_edge(int vertex) {
    std::vector<int>& here = unused_[vertex];
    if (here.empty()) return -1;
    auto taken = std::ranges::find_if(here, [&](int h) { return end_vertex(soup_, h) == vertex; });
    if (taken == here.end()) taken = here.begin();
    const int half_edge = *taken;
    here.erase(taken);
    std::erase(unused_[start_vertex(soup_, half_edge) + end_vertex(soup_, half_edge) - vertex],
               half_edge);
    return half_edge;
  }

  /// Gives up the last edge, which leads nowhere, and returns where it began.
  int step_back() {
    const int vertex = path_.vertices.back();
    path_.vertices.pop_back();
    path_.half_edges.pop_back();
    step_of_.erase(vertex);
    return vertex;
  }

  /// Takes off what the path has walked since one of its vertices.
  void take_loop(int first) {
    BorderLoop loop;
    loop.vertices.assign(path_.vertices.begin() + first, path_.vertices.end());
    loop.half_edges.assign(path_.half_edges.begin() + first, path_.half_edges.end());
    path_.vertices.resize(first);
    path_.half_edges.resize(first);
    for (const int vertex : loop.vertices) step_of_.erase(vertex);
    turn_against_faces(loop);
    loops_.push_back(std::move(loop));
  }

  void turn_against_faces(BorderLoop& loop) const {
    std::size_t along = 0;
    for (std::size_t i = 0; i < loop.vertices.size(); ++i) {
      along += start_vertex(soup_, loop.half_edges[i]) == loop.vertices[i];
    }
    if (2 * along <= loop.vertices.size()) return;
    std::reverse(loop.vertices.begin() + 1, loop.vertices.end());
    std::reverse(loop.half_edges.begin(), loop.half_edges.end());
  }
};

}  // namespace

std::vector<BorderLoop> find_border_loops(const TriangleSoup& soup) {
  return BorderWalk(soup).loops();
}

}  // namespace foldwright
