#include "parts.h"

namespace foldwright::testing {

Unfoldable unfoldable(Mesh mesh) {
  DualGraph graph = build_dual_graph(mesh);
  return {std::move(mesh), std::move(graph)};
}

FoldabilityMatrix learn(const Unfoldable& surface, int runs) {
  FoldabilityLearner learner(surface.mesh, surface.graph, {.runs = runs}, {0, runs});
  while (learner.step()) continue;
  return to_matrix(learner.counts());
}

std::string fault_of_parts(const DualGraph& graph, const Labels& labels) {
  if (static_cast<int>(labels.size()) != graph.panel_count()) return "a panel without a label";
  if (part_count(labels) != part_count(renumbered(labels))) return "a number that no panel has";
  const int pieces = part_count(part_pieces(graph, labels));
  if (pieces == part_count(labels)) return "";
  return std::to_string(pieces) + " pieces of " + std::to_string(part_count(labels)) + " parts";
}

}  // namespace foldwright::testing
