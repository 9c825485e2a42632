#include "pipeline/nets/congruent_nets.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "pipeline/sheets/flat_net.h"
#include "unfold/layout.h"

namespace foldwright {
namespace {

bool may_have_twins(const FoundNet& net) {
  return !net.region.kept && net.motion.kind != Folding::kWaypoints && !net.folds.empty();
}

}  // namespace

std::vector<std::optional<Twin>> find_twins(const JobState& state) {
  std::vector<int> order(state.nets.found.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(
      order, {}, [&](int n) { return state.nets.found[n].motion.kind != Folding::kLine; });
  std::vector<std::optional<Twin>> twins(state.nets.found.size());
  std::vector<std::pair<int, DualGraph>> models;  // nets that are like none before
  for (const int n : order) {
    const FoundNet& net = state.nets.found[n];
    if (!may_have_twins(net)) continue;
    DualGraph graph = graph_of(state, net);
    for (const auto& [model, of_model] : models) {
      auto congruence = find_congruence(state.model.surface->mesh, of_model, graph);
      if (!congruence) continue;
      twins[n] = {model, *std::move(congruence)};
      break;
    }
    if (!twins[n]) models.emplace_back(n, std::move(graph));
  }
  return twins;
}

std::optional<FoundNet> copy_of_twin(const JobState& state, const FoundNet& net, const Twin& twin) {
  const Component& component = state.parts.components[net.region.component];
  const DualGraph graph = graph_of(state, net);
  const FoundNet& other = state.nets.found[twin.of];
  std::vector<int> edges;
  for (const int fold : other.folds) {
    edges.push_back(graph.hinges[twin.congruence.hinges[fold]].edges[0]);
  }
  FoundNet copy = copy_net(component, net.region, edges, other.motion);
  copy.place = net.place;
  if (overlaps_itself(component, copy)) return std::nullopt;
  if (copy.motion.certified() && !is_exact(twin.congruence)) copy.motion = {};
  return copy;
}

FoundNet copy_net(const Component& component, Region region, std::span<const int> edges,
                  const FoldMotion& motion) {
  const std::map<int, int> hinge_of = hinges_by_edge(restrict_to(component.graph, region.panels));
  std::vector<std::pair<int, std::size_t>> folds;  // hinge, and the fold it was
  for (std::size_t i = 0; i < edges.size(); ++i) folds.emplace_back(hinge_of.at(edges[i]), i);
  std::ranges::sort(folds);
  FoundNet copy{std::move(region), {}, {motion.kind, motion.times, {}}};
  copy.motion.shares.resize(motion.shares.size());
  for (const auto& [hinge, was] : folds) {
    copy.folds.push_back(hinge);
    for (std::size_t key = 0; key < motion.shares.size(); ++key) {
      copy.motion.shares[key].push_back(motion.shares[key][was]);
    }
  }
  return copy;
}

bool overlaps_itself(const Component& component, const FoundNet& net) {
  const DualGraph graph = restrict_to(component.graph, net.region.panels);
  return !overlapping_panels(graph, lay_out(graph, hang_tree(graph, net.folds))).empty();
}

}  // namespace foldwright
