#include "trees.h"

namespace foldwright::testing {
namespace {

/// Whether two panels are joined by the given hinges, by walking from one.
bool joined(const DualGraph& graph, const FoldTree& folds, int from, int to) {
  std::vector<char> reached(graph.panel_count(), 0);
  reached[from] = 1;
  for (bool grew = true; grew;) {
    grew = false;
    for (const int h : folds) {
      const auto& [a, b] = graph.hinges[h].panels;
      if (reached[a] == reached[b]) continue;
      reached[a] = reached[b] = 1;
      grew = true;
    }
  }
  return reached[to];
}

/// Adds hinges from `next` on in every way that makes no circle.
void extend(const DualGraph& graph, int next, FoldTree& folds, std::vector<FoldTree>& trees) {
  if (static_cast<int>(folds.size()) == graph.panel_count() - 1) {
    trees.push_back(folds);
    return;
  }
  for (int h = next; h < graph.hinge_count(); ++h) {
    const auto& [a, b] = graph.hinges[h].panels;
    if (joined(graph, folds, a, b)) continue;
    folds.push_back(h);
    extend(graph, h + 1, folds, trees);
    folds.pop_back();
  }
}

}  // namespace

std::vector<FoldTree> all_spanning_trees(const DualGraph& graph) {
  std::vector<FoldTree> trees;
  FoldTree folds;
  extend(graph, 0, folds, trees);
  return trees;
}

FoldTree random_tree(const DualGraph& graph, Random& random) {
  std::vector<double> weights(graph.hinge_count());
  for (double& weight : weights) weight = random.uniform();
  return minimum_spanning_tree(graph, weights);
}

std::vector<std::array<int, 2>> overlaps_of(const DualGraph& graph, const FoldTree& folds) {
  return overlapping_panels(graph, lay_out(graph, hang_tree(graph, folds)));
}

bool is_net(const Mesh& mesh, const DualGraph& graph, const FoldTree& folds) {
  return check_net(mesh, make_net(mesh, graph, folds)).valid();
}

}  // namespace foldwright::testing
