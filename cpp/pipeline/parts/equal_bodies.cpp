#include "pipeline/parts/equal_bodies.h"

#include <algorithm>

#include "pipeline/nets/congruent_nets.h"

namespace foldwright {

void find_equal_bodies(std::vector<Component>& components, const Mesh& mesh) {
  std::vector<int> models;  // bodies that are like none before
  for (std::size_t c = 0; c < components.size(); ++c) {
    Component& component = components[c];
    for (const int like : models) {
      if (components[like].parts != component.parts) continue;
      auto congruence = find_congruence(mesh, components[like].graph, component.graph);
      if (!congruence) continue;
      component.equal_to = {like, *std::move(congruence)};
      break;
    }
    if (!component.equal_to) models.push_back(static_cast<int>(c));
  }
}

void carry_labels_of_equal(const std::vector<Component>& components, Component& component) {
  const auto& [like, congruence] = *component.equal_to;
  const Labels& labels = components[like].labels;
  component.labels.resize(labels.size());
  for (std::size_t panel = 0; panel < labels.size(); ++panel) {
    component.labels[congruence.panels[panel]] = labels[panel];
  }
}

bool follow_equal_bodies(JobState& state) {
  bool has_changed = false;
  for (Component& component : state.parts.components) {
    if (!component.equal_to) continue;
    const Labels before = component.labels;
    carry_labels_of_equal(state.parts.components, component);
    has_changed |= component.labels != before;
    while (static_cast<int>(component.part_numbers.size()) < part_count(component.labels)) {
      component.part_numbers.push_back(state.parts.count++);
    }
  }
  return has_changed;
}

std::vector<FoundNet> nets_of_equal(const JobState& state, int index) {
  const Component& component = state.parts.components[index];
  const auto& [like, congruence] = *component.equal_to;
  const Component& other = state.parts.components[like];
  const std::map<int, int> hinge_of = hinges_by_edge(other.graph);
  std::vector<FoundNet> nets;
  std::size_t panels = 0;
  for (const FoundNet& net : state.nets.found) {
    if (net.region.component != like) continue;
    Region region = net.region;
    region.component = index;
    region.part = component.part_numbers[other.labels[net.region.panels[0]]];
    for (int& panel : region.panels) panel = congruence.panels[panel];
    std::ranges::sort(region.panels);
    panels += region.panels.size();
    const DualGraph graph = restrict_to(other.graph, net.region.panels);
    std::vector<int> edges;
    for (const int fold : net.folds) {
      const int hinge = congruence.hinges[hinge_of.at(graph.hinges[fold].edges[0])];
      edges.push_back(component.graph.hinges[hinge].edges[0]);
    }
    nets.push_back(copy_net(component, std::move(region), edges, net.motion));
    if (overlaps_itself(component, nets.back())) return {};
    if (net.motion.certified() && !is_exact(congruence)) nets.back().motion = {};
  }
  if (panels != component.panels.size()) return {};
  return nets;
}

void add_nets_of_equal(JobState& state) {
  follow_equal_bodies(state);
  for (int c = 0; c < static_cast<int>(state.parts.components.size()); ++c) {
    if (!state.parts.components[c].equal_to) continue;
    std::ranges::move(nets_of_equal(state, c), std::back_inserter(state.nets.found));
  }
}

}  // namespace foldwright
