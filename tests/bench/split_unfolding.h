#pragma once

#include <algorithm>

#include "unfold/directions.h"
#include "unfold/heuristics.h"
#include "unfold/layout.h"

namespace foldwright::testing {

/// Per panel the piece it is in when an unfolding is cut wherever a panel would overlap its piece.
inline std::vector<int> split_at_overlaps(const RootedTree& tree,
                                          std::span<const std::array<int, 2>> overlaps) {
  std::vector<std::vector<int>> partners(tree.order.size());
  for (const auto& [a, b] : overlaps) {
    partners[a].push_back(b);
    partners[b].push_back(a);
  }
  std::vector<int> piece(tree.order.size(), -1);
  int pieces = 0;
  for (const int panel : tree.order) {
    const int parent = tree.parent[panel];
    const auto collides = [&](int other) { return piece[other] == piece[parent]; };
    const bool starts =
        parent == -1 || std::any_of(partners[panel].begin(), partners[panel].end(), collides);
    piece[panel] = starts ? pieces++ : piece[parent];
  }
  return piece;
}

/// "Unfold and split", what there was before the paper: of 60 unfoldings by steepest edge and flat
/// tree in random directions the one that falls into the fewest pieces; the piece of every panel.
inline std::vector<int> unfold_and_split(const Mesh& mesh, const DualGraph& graph) {
  constexpr int kUnfoldings = 60;
  const HeuristicWeights weights(mesh, graph);
  Random random(1);
  const auto directions = make_directions(mesh, DirectionSet::kRandom, kUnfoldings, random);
  std::vector<int> fewest;
  int least = graph.panel_count() + 1;
  for (int run = 0; run < kUnfoldings; ++run) {
    const auto hybrid = weights.weights(Heuristic::kHybrid, directions[run], run, random);
    const RootedTree tree = hang_tree(graph, minimum_spanning_tree(graph, hybrid));
    auto piece = split_at_overlaps(tree, overlapping_panels(graph, lay_out(graph, tree)));
    const int count = 1 + *std::max_element(piece.begin(), piece.end());
    if (count < least) least = count, fewest = std::move(piece);
  }
  return fewest;
}

}  // namespace foldwright::testing
