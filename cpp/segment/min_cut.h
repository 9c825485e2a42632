#pragma once

#include <vector>

namespace foldwright {

/// Least cut of an undirected network between a source and a sink, by Dinic's algorithm.
class MinCut {
 public:
  explicit MinCut(int nodes);

  /// Costs of having `node` on the sink's side, and on the source's; not negative, and not both
  /// infinite.
  void add_terminal(int node, double on_sink_side, double on_source_side);
  /// Cost of having the two on different sides; not negative, and finite.
  void add_link(int a, int b, double cost);

  /// Per node whether it is on the source's side of a least cut: of all of those the one with the
  /// fewest nodes there. Cost: little above linear for networks that are nearly planar.
  std::vector<char> solve();

 private:
  struct Arc {
    int to;
    double room;  ///< residual capacity; the opposite arc is the one beside it
  };

  void add_arcs(int from, int to, double there, double back);
  bool find_levels();
  bool advance();

  int source_, sink_;
  std::vector<Arc> arcs_;
  std::vector<std::vector<int>> arcs_of_;
  std::vector<int> level_, next_;
  double least_room_ = 0;  ///< below it an arc counts as full
};

}  // namespace foldwright
