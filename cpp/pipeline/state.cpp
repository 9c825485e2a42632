#include "pipeline/state.h"

#include <algorithm>

namespace foldwright {

Component make_component(const DualGraph& model, std::vector<int> panels) {
  Component component;
  component.graph = restrict_to(model, panels);
  component.panels = std::move(panels);
  component.convex = std::all_of(component.graph.hinges.begin(), component.graph.hinges.end(),
                                 [](const Hinge& hinge) { return hinge.angle <= kPanelAngle; });
  return component;
}

void label_faces(JobState& state) {
  for (const Component& component : state.components) {
    for (int panel = 0; panel < component.graph.panel_count(); ++panel) {
      const int part = component.part_numbers[component.labels[panel]];
      for (const int face : component.graph.panel_faces(panel)) state.result.labels[face] = part;
    }
  }
}

}  // namespace foldwright
