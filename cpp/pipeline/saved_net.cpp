#include "pipeline/saved_net.h"

#include <algorithm>

#include "geometry/union_find.h"

namespace foldwright {
namespace {

void check(bool valid) {
  if (!valid) throw foreign_start();
}

/// The panels that are made of the given faces.
std::vector<int> panels_of_faces(const DualGraph& graph, std::vector<int> faces) {
  std::ranges::sort(faces);
  std::vector<int> panels;
  for (int panel = 0; panel < graph.panel_count(); ++panel) {
    const int first = graph.panel_faces(panel)[0];
    if (std::ranges::binary_search(faces, first)) panels.push_back(panel);
  }
  std::vector<int> found = restrict_to(graph, panels).faces;
  std::ranges::sort(found);
  check(!panels.empty() && found == faces);
  return panels;
}

/// The folds as hinges. They must span the graph.
FoldTree hinges_of_edges(const DualGraph& graph, std::span<const int> edges) {
  const std::map<int, int> hinge_of = hinges_by_edge(graph);
  UnionFind joined(graph.panel_count());
  FoldTree folds;
  for (const int edge : edges) {
    const auto found = hinge_of.find(edge);
    check(found != hinge_of.end());
    const auto& [a, b] = graph.hinges[found->second].panels;
    check(joined.join(a, b));
    folds.push_back(found->second);
  }
  check(static_cast<int>(folds.size()) == graph.panel_count() - 1);
  return folds;
}

void check_motion(const FoldMotion& motion, std::size_t folds) {
  check(motion.shares.size() == motion.times.size());
  check(motion.times.size() >= 2 || !motion.certified());
  if (motion.times.empty()) return;
  check(motion.times.front() == 0 && motion.times.back() == 1);
  const auto falls = [](double a, double b) { return !(a < b); };
  check(std::ranges::adjacent_find(motion.times, falls) == motion.times.end());
  for (const std::vector<double>& shares : motion.shares) {
    check(shares.size() == folds);
    check(std::ranges::all_of(shares, [](double share) { return share >= 0 && share <= 1; }));
  }
}

}  // namespace

InputError foreign_start() { return InputError("bad-start"); }

SavedNet save_net(const Component& component, const FoundNet& net) {
  const DualGraph graph = restrict_to(component.graph, net.region.panels);
  SavedNet saved{net.region.part, net.region.cause, graph.faces, {}, net.motion, net.place};
  std::ranges::sort(saved.faces);
  for (const int hinge : net.folds) saved.folds.push_back(graph.hinges[hinge].edges[0]);
  return saved;
}

FoundNet load_net(const Component& component, int index, const SavedNet& saved) {
  FoundNet net{{index, saved.part, saved.cause, {}}, {}, saved.motion, saved.place};
  net.region.kept = true;
  net.region.panels = panels_of_faces(component.graph, saved.faces);
  net.folds = hinges_of_edges(restrict_to(component.graph, net.region.panels), saved.folds);
  check_motion(saved.motion, net.folds.size());
  return net;
}

}  // namespace foldwright
