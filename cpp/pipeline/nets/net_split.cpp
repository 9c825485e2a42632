#include "pipeline/nets/net_split.h"

#include <algorithm>
#include <map>

namespace foldwright {
namespace {

/// Per panel of the graph, whether it hangs below the fold that is cut.
std::vector<char> below(const RootedTree& tree, int cut_hinge) {
  std::vector<char> side(tree.parent.size(), 0);
  for (const int panel : tree.order) {
    if (tree.parent[panel] == -1) continue;
    side[panel] = tree.hinge[panel] == cut_hinge || side[tree.parent[panel]];
  }
  return side;
}

}  // namespace

std::array<FoundNet, 2> split_net(const Component& component, const FoundNet& net, int fold) {
  const DualGraph whole = restrict_to(component.graph, net.region.panels);
  const std::vector<char> side = below(hang_tree(whole, net.folds), net.folds[fold]);
  std::array<FoundNet, 2> halves;
  for (const int half : {0, 1}) {
    FoundNet& piece = halves[half];
    piece.region = net.region;
    piece.region.cause = Cause::kSheet;
    piece.region.panels.clear();
    for (std::size_t i = 0; i < side.size(); ++i) {
      if (side[i] == half) piece.region.panels.push_back(net.region.panels[i]);
    }
    const DualGraph graph = restrict_to(component.graph, piece.region.panels);
    const std::map<int, int> hinge_of = hinges_by_edge(graph);
    std::vector<std::pair<int, std::size_t>> kept;  // hinge, and the fold it was
    for (std::size_t i = 0; i < net.folds.size(); ++i) {
      const Hinge& hinge = whole.hinges[net.folds[i]];
      if (static_cast<int>(i) == fold || side[hinge.panels[0]] != half) continue;
      kept.emplace_back(hinge_of.at(hinge.edges[0]), i);
    }
    std::sort(kept.begin(), kept.end());
    piece.motion.kind = net.motion.kind;
    piece.motion.times = net.motion.times;
    piece.motion.shares.resize(net.motion.shares.size());
    for (const auto& [hinge, was] : kept) {
      piece.folds.push_back(hinge);
      for (std::size_t key = 0; key < net.motion.shares.size(); ++key) {
        piece.motion.shares[key].push_back(net.motion.shares[key][was]);
      }
    }
  }
  return halves;
}

}  // namespace foldwright
