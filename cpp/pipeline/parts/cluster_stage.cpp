#include "mesh/input_error.h"
#include "pipeline/parts/equal_bodies.h"
#include "pipeline/parts/matrix_picture.h"
#include "pipeline/sheets/model_size.h"
#include "pipeline/stage.h"
#include "segment/curvature_pockets.h"
#include "segment/lock_labels.h"
#include "segment/regroup.h"
#include "segment/subdivide.h"

namespace foldwright {
namespace {

/// Labels of the surface that was learned on, one per row of the matrix.
Labels label_learned(const JobState& state, const Component& component) {
  const Learned& learned = *component.learned;
  const Mesh& mesh = learned.surface->mesh;
  const DualGraph graph = restrict_to(learned.surface->graph, learned.panels);
  const JobOptions& options = state.options;
  // An edit has chosen the numbers of its parts: what is split is not a body but a part.
  const bool is_part = !component.part_numbers.empty();
  if (is_part && options.parts.segmenter == Segmenter::kShape) {
    return subdivide(mesh, graph, learned.matrix, {.parts = component.parts, .seed = options.seed});
  }
  return segment(mesh, graph, learned.matrix,
                 {.segmenter = options.parts.segmenter,
                  .parts = component.parts,
                  .whole_first = component.whole_first,
                  .seed = options.seed,
                  .largest_area = largest_part_area(state.model.surface->mesh, options.paper)});
}

/// Makes parts of one component [paper, 4.2]. Returns the labels of the surface that was learned
/// on, one per row of the matrix; empty when nothing was learned and the component stays whole.
Labels label_component(const JobState& state, Component& component) {
  if (component.equal_to) {
    carry_labels_of_equal(state.parts.components, component);
    return {};
  }
  component.labels.assign(component.graph.panel_count(), 0);
  if (!component.learned) return {};
  const Learned& learned = *component.learned;
  Labels on_learned = label_learned(state, component);
  const Mesh& mesh = state.model.surface->mesh;
  Labels labels = carry_labels(mesh, component.graph, {learned.matrix, learned.rows}, on_learned);
  const Segmenter segmenter = state.options.parts.segmenter;
  const int learned_panels = learned.matrix.size;
  labels = smooth_labels(mesh, component.graph, std::move(labels), {segmenter, learned_panels});
  if (segmenter == Segmenter::kShape) {
    labels = regroup_saddles(mesh, component.graph, learned_panels, std::move(labels));
  }
  labels = open_pockets(mesh, component.graph, std::move(labels));
  component.labels = keep_locked_together(component.graph, std::move(labels));
  return on_learned;
}

/// What an edit asks for, and folds that are never to be cut do not allow.
InputError held_together(const Component& component) {
  return InputError("locked", {{"what", "parts"}, {"parts", component.part_numbers.size()}});
}

/// Makes the parts, and numbers them through all components.
class ClusterStage : public Stage {
 public:
  StageId id() const override { return StageId::kCluster; }

  void begin(JobState& state, TaskQueue&, Events& events) override {
    state.parts.labels.assign(state.model.surface->mesh.faces.size(), -1);
    for (Component& component : state.parts.components) {
      show_matrix(component, label_component(state, component), state.options.parts.runs, events);
      const int parts = part_count(component.labels);
      if (parts < static_cast<int>(component.part_numbers.size())) throw held_together(component);
      for (int part = 0; component.part_numbers.size() < static_cast<std::size_t>(parts); ++part) {
        component.part_numbers.push_back(state.parts.count + part);
      }
      state.parts.count += parts;
    }
    label_faces(state);
    events.push_back(SegmentedEvent{state.parts.labels});
    done_ = true;
  }

  double progress(const JobState&, const Running&) const override { return done_ ? 1 : 0; }

 private:
  /// The matrix of the first component that has one, in blocks [paper, Fig. 7].
  void show_matrix(const Component& component, const Labels& labels, int runs, Events& events) {
    if (shown_ || labels.empty()) return;
    shown_ = true;
    events.push_back(
        LearnedEvent{runs, runs, make_matrix_picture(component.learned->matrix, labels)});
  }

  bool shown_ = false;
  bool done_ = false;
};

}  // namespace

std::unique_ptr<Stage> make_cluster_stage() { return std::make_unique<ClusterStage>(); }

}  // namespace foldwright
