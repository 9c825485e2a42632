#include "pipeline/state.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace foldwright {
namespace {

// Creases of so many times the square root of the surface are few: on a piece that fills A4 they
// add up to eight metres, the work of an afternoon. Decimated animals reach it at 350 faces; parts
// that people draw on finely meshed models begin at three times as many.
constexpr double kFewBends = 52;

// More panels than this are not few, however short their edges are.
constexpr int kFewPanels = 1000;

bool has_few_bends(const DualGraph& graph) {
  double length = 0;
  for (const Hinge& hinge : graph.hinges) length += hinge.length;
  const double area = std::accumulate(graph.areas.begin(), graph.areas.end(), 0.0);
  return graph.panel_count() <= kFewPanels && length <= kFewBends * std::sqrt(area);
}

bool is_convex(const DualGraph& graph) {
  return std::ranges::all_of(graph.hinges,
                             [](const Hinge& hinge) { return hinge.angle <= kPanelAngle; });
}

}  // namespace

Component make_component(const DualGraph& model, std::vector<int> panels) {
  Component component;
  component.graph = restrict_to(model, panels);
  component.panels = std::move(panels);
  component.whole_first = is_convex(component.graph) || has_few_bends(component.graph);
  return component;
}

const EarlierPaper* earlier_paper(const JobState& state) {
  return state.start && state.start->paper ? &*state.start->paper : nullptr;
}

std::vector<int> model_panels(const JobState& state, const Region& region) {
  std::vector<int> panels;
  for (const int panel : region.panels) {
    panels.push_back(state.parts.components[region.component].panels[panel]);
  }
  return panels;
}

void make_parts_of_pieces(JobState& state) {
  int part_before = -1;
  for (FoundNet& net : state.nets.found) {
    Region& region = net.region;
    region.cause = Cause::kPart;
    if (region.part != std::exchange(part_before, region.part)) continue;
    Component& component = state.parts.components[region.component];
    const int label = static_cast<int>(component.part_numbers.size());
    for (const int panel : region.panels) component.labels[panel] = label;
    region.part = state.parts.count++;
    component.part_numbers.push_back(region.part);
  }
  sort_nets(state);
}

void sort_nets(JobState& state) {
  std::ranges::sort(state.nets.found, {}, [](const FoundNet& net) {
    return std::pair(net.region.part, net.region.panels[0]);
  });
}

void label_faces(JobState& state) {
  for (const Component& component : state.parts.components) {
    for (int panel = 0; panel < component.graph.panel_count(); ++panel) {
      const int part = component.part_numbers[component.labels[panel]];
      for (const int face : component.graph.panel_faces(panel)) state.parts.labels[face] = part;
    }
  }
}

}  // namespace foldwright
