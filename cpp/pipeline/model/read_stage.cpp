#include <algorithm>
#include <cmath>
#include <numeric>

#include "mesh/input_error.h"
#include "pipeline/edits/edits.h"
#include "pipeline/edits/net_edits.h"
#include "pipeline/parts/equal_bodies.h"
#include "pipeline/sheets/recut_nets.h"
#include "pipeline/stage.h"

namespace foldwright {
namespace {

std::vector<Component> make_components(const DualGraph& graph) {
  const Labels one_part(graph.panel_count(), 0);
  const std::vector<int> component_of = part_pieces(graph, one_part);
  std::vector<std::vector<int>> panels(part_count(component_of));
  for (int panel = 0; panel < graph.panel_count(); ++panel) {
    panels[component_of[panel]].push_back(panel);
  }
  std::vector<Component> components;
  for (std::vector<int>& of : panels) components.push_back(make_component(graph, std::move(of)));
  return components;
}

/// Hands `wanted` parts out to the components by area: one each, the rest by largest remainder.
void share_parts(std::vector<Component>& components, int wanted) {
  double total = 0;
  std::vector<double> areas;
  for (Component& component : components) {
    component.parts = 1;
    const auto& panels = component.graph.areas;
    areas.push_back(std::accumulate(panels.begin(), panels.end(), 0.0));
    total += areas.back();
  }
  for (int left = wanted - static_cast<int>(components.size()); left > 0; --left) {
    int neediest = -1;
    double most = 0;
    for (std::size_t i = 0; i < components.size(); ++i) {
      if (components[i].parts >= components[i].graph.panel_count()) continue;
      const double need = areas[i] / total * wanted / components[i].parts;
      if (need > most) most = need, neediest = static_cast<int>(i);
    }
    if (neediest == -1) return;
    ++components[neediest].parts;
  }
}

/// Fits the number of parts to what the model allows, and says so where it differs.
void decide_parts(JobState& state) {
  const int wanted = state.options.parts.count;
  if (wanted == 0) return;
  const int least = static_cast<int>(state.parts.components.size());
  const int most = state.model.surface->graph.panel_count();
  if (wanted < least) {
    state.notices.push_back({"parts-raised", {{"what", "bodies"}, {"bodies", least}}});
  } else if (wanted > most) {
    state.notices.push_back({"parts-lowered", {{"panels", most}}});
  }
  share_parts(state.parts.components, std::clamp(wanted, least, most));
}

/// Seconds that a job over so many panels takes on two cores, roughly: measured in Chromium over a
/// bust in 12 parts, 5000 faces take 5, 20,000 take 16 and 70,000 take 229.
double foreseen_seconds(double panels) { return 7e-4 * panels + 5.2e-13 * std::pow(panels, 3); }

/// Paper models have some hundred faces: what is proposed where there are far too many.
constexpr int kProposedFaces = 1500;

/// Says before the search what a model of more faces than people fold will cost, and refuses one
/// whose search would not end. Whoever asked for a number of faces knows.
void foresee_cost(JobState& state, Events& events) {
  constexpr int kFoldableFaces = 2000;
  // The foreseen time grows with the cube of this number; here it is ten minutes.
  constexpr int kMostPanels = 100'000;
  const int faces = state.model.surface->mesh.face_count();
  const int panels = state.model.surface->graph.panel_count();
  if (state.options.model.faces > 0 || panels <= kFoldableFaces) return;
  if (panels > kMostPanels) {
    throw InputError("too-many-faces",
                     {{"faces", panels}, {"most", kMostPanels}, {"proposed", kProposedFaces}});
  }
  const Notice notice(
      "large-model",
      {{"faces", faces}, {"seconds", foreseen_seconds(panels)}, {"proposed", kProposedFaces}});
  state.notices.push_back(notice);
  events.push_back(notice);
}

/// A job that locks an edge makes it what the lock says; the jobs after it keep that.
std::vector<EdgeLock> locks_in_force(const JobState& state) {
  if (!state.start) return state.options.parts.locks;
  return locks_before(state.options.parts.locks, state.start->net_edits);
}

/// From bytes to components: read, repair, simplify, dual graph.
class ReadStage : public Stage {
 public:
  explicit ReadStage(std::vector<ModelFile> files) : files_(std::move(files)) {}

  StageId id() const override { return StageId::kRead; }

  void begin(JobState& state, TaskQueue&, Events& events) override {
    check_options(state.options);
    state.parts.names = state.options.paper.names;
    state.parts.pins = state.options.paper.pins;
    state.model.source =
        state.memory->model.read(files_, state.options.model, state.memory->uniter);
    files_ = {};
    const SourceModel& model = *state.model.source;
    state.notices = model.notices;
    // At once, for what comes may take long, or fail.
    for (const Repair& repair : model.repairs) events.push_back(message_of(repair));
    state.model.surface = make_surface(kModelSurface, model.mesh, locks_in_force(state));
    events.push_back(ModelEvent{state.model.surface, model.file});
    check_panels_fit(state);
    if (state.start) {
      start_from_earlier(state);
    } else {
      foresee_cost(state, events);
      state.parts.components = make_components(state.model.surface->graph);
      decide_parts(state);
      find_equal_bodies(state.parts.components, state.model.surface->mesh);
    }
  }

  double progress(const JobState& state, const Running&) const override {
    return state.model.surface ? 1 : 0;
  }

 private:
  std::vector<ModelFile> files_;  ///< until they are read: they may be large
};

}  // namespace

std::unique_ptr<Stage> make_read_stage(std::vector<ModelFile> files) {
  return std::make_unique<ReadStage>(std::move(files));
}

}  // namespace foldwright
