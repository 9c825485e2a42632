#include "pipeline/stage.h"

namespace foldwright {
namespace {

/// Parts of one component, as labels of its own panels [paper, 4.2].
Labels component_labels(const JobState& state, const Component& component) {
  if (!component.learned) return Labels(component.graph.panel_count(), 0);
  const Learned& learned = *component.learned;
  const DualGraph graph = restrict_to(learned.surface->graph, learned.panels);
  const SegmentOptions options = {state.options.segmenter, component.parts, state.options.seed};
  const Labels on_learned = segment(learned.surface->mesh, graph, learned.matrix, options);
  return carry_labels(state.surface->mesh, component.graph, {learned.matrix, learned.rows},
                      on_learned);
}

/// Makes the parts, and numbers them through all components.
class ClusterStage : public Stage {
 public:
  StageId id() const override { return StageId::kCluster; }

  void begin(JobState& state, TaskQueue&, Events& events) override {
    JobResult& result = state.result;
    result.labels.assign(state.surface->mesh.faces.size(), -1);
    for (Component& component : state.components) {
      component.labels = component_labels(state, component);
      for (int panel = 0; panel < component.graph.panel_count(); ++panel) {
        for (const int face : component.graph.panel_faces(panel)) {
          result.labels[face] = state.parts + component.labels[panel];
        }
      }
      state.parts += part_count(component.labels);
    }
    events.push_back(SegmentedEvent{result.labels});
    done_ = true;
  }

  double progress(const JobState&, const TaskRunner*) const override { return done_ ? 1 : 0; }

 private:
  bool done_ = false;
};

}  // namespace

std::unique_ptr<Stage> make_cluster_stage() { return std::make_unique<ClusterStage>(); }

}  // namespace foldwright
