#include <algorithm>
#include <cmath>
#include <numeric>

#include "mesh/carry_origins.h"
#include "mesh/input_error.h"
#include "mesh/nearest_face.h"
#include "mesh/simplify.h"
#include "pipeline/edits.h"
#include "pipeline/net_edits.h"
#include "pipeline/recut_nets.h"
#include "pipeline/stage.h"
#include "read/read_model.h"
#include "read/turn_up.h"
#include "repair/joints.h"

namespace foldwright {
namespace {

Axis up_of(const PolygonSoup& soup, Up asked) {
  switch (asked) {
    case Up::kX:
      return Axis::kX;
    case Up::kY:
      return Axis::kY;
    case Up::kZ:
      return Axis::kZ;
    case Up::kGuess:
      break;
  }
  return soup.usual_up;
}

/// Tells what of the file's looks is not printed.
void tell_looks(const PolygonSoup& soup, JobState& state) {
  if (!soup.has_colours && !soup.has_textures) return;
  const char* looks = !soup.has_textures ? "colours" : !soup.has_colours ? "textures" : "both";
  state.notices.push_back({"materials-ignored", {{"what", looks}}});
}

/// Tells which files came along that nothing is made of.
void tell_ignored(JobState& state) {
  if (state.files.empty()) return;
  std::vector<std::string> names;
  for (const ModelFile& file : state.files) names.push_back(file.name);
  state.notices.push_back({"files-ignored", {{"files", names}}});
}

/// Reads the model among the files, frees it, and keeps the others.
PolygonSoup read_files(JobState& state) {
  const auto chosen = state.files.begin() + static_cast<std::ptrdiff_t>(find_model(state.files));
  const ModelFile model = std::move(*chosen);
  state.files.erase(chosen);
  state.model_file = model.name;
  return read_model(model.bytes, model.name);
}

/// The files' model with y up. A guess is told where the model was turned for it.
PolygonSoup read_upright(JobState& state) {
  PolygonSoup soup = read_files(state);
  tell_ignored(state);
  tell_looks(soup, state);
  const Axis up = up_of(soup, state.options.up);
  turn_up(soup.positions, up);
  if (state.options.up == Up::kGuess && up != Axis::kY) {
    state.notices.push_back({"up-guessed"});
  }
  return soup;
}

/// Simplifies on demand, and remembers which face stands for which.
Mesh simplified(JobState& state) {
  Mesh mesh = std::move(state.model.mesh);
  state.source_faces = mesh.source_faces;
  const int wanted = state.options.faces;
  if (wanted == 0 || mesh.face_count() <= wanted) return mesh;
  Mesh simple = simplify(mesh, {.target_faces = wanted});
  state.face_standins = nearest_faces(mesh, simple);
  state.model.origins = carry_origins(mesh, state.model.origins, simple);
  state.simplified_deviation = largest_deviation(mesh, simple);
  simple.joints = find_joints(simple);
  if (const auto lost = static_cast<int>(mesh.joints.size() - simple.joints.size()); lost > 0) {
    state.notices.push_back({"joints-lost", {{"count", lost}}});
  }
  if (simple.face_count() > wanted) {
    state.notices.push_back({"faces-above-wish", {{"faces", simple.face_count()}}});
  }
  return simple;
}

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
  const int wanted = state.options.parts;
  if (wanted == 0) return;
  const int least = static_cast<int>(state.components.size());
  const int most = state.surface->graph.panel_count();
  if (wanted < least) {
    state.notices.push_back({"parts-raised", {{"what", "bodies"}, {"bodies", least}}});
  } else if (wanted > most) {
    state.notices.push_back({"parts-lowered", {{"panels", most}}});
  }
  share_parts(state.components, std::clamp(wanted, least, most));
}

/// Seconds that a job over so many panels takes on two cores, roughly: measured in Chromium over a
/// bust in 12 parts, 5000 faces take 5, 20,000 take 16 and 70,000 take 229.
double foreseen_seconds(double panels) { return 7e-4 * panels + 5.2e-13 * std::pow(panels, 3); }

/// Says before the search what a large model will cost, and what would be quicker. Whoever asked
/// for a number of faces knows.
void foresee_cost(JobState& state, Events& events) {
  constexpr double kWorthTelling = 12;  // seconds
  // Far below what takes long, and most that one makes of paper in weeks.
  constexpr int kProposedFaces = 3000;
  const double seconds = foreseen_seconds(state.surface->graph.panel_count());
  if (seconds < kWorthTelling || state.options.faces > 0) return;
  const Notice notice("large-model", {{"faces", state.surface->mesh.face_count()},
                                      {"seconds", seconds},
                                      {"proposed", kProposedFaces}});
  state.notices.push_back(notice);
  events.push_back(notice);
}

/// A job that locks an edge makes it what the lock says; the jobs after it keep that.
std::vector<EdgeLock> locks_in_force(const JobState& state) {
  if (!state.start) return state.options.locks;
  return locks_before(state.options.locks, state.start->net_edits);
}

/// From bytes to components: read, repair, simplify, dual graph.
class ReadStage : public Stage {
 public:
  StageId id() const override { return StageId::kRead; }

  void begin(JobState& state, TaskQueue&, Events& events) override {
    check_options(state.options);
    state.names = state.options.names;
    state.pins = state.options.pins;
    const PolygonSoup soup = read_upright(state);
    state.model = repair(soup);
    // At once, for what comes may take long, or fail.
    for (const Repair& repair : state.model.repairs) events.push_back(message_of(repair));
    state.surface = make_surface(kModelSurface, simplified(state), locks_in_force(state));
    events.push_back(ModelEvent{state.surface, state.model_file});
    check_panels_fit(state);
    if (state.start) {
      start_from_earlier(state);
    } else {
      foresee_cost(state, events);
      state.components = make_components(state.surface->graph);
      decide_parts(state);
    }
  }

  double progress(const JobState& state, const Running&) const override {
    return state.surface ? 1 : 0;
  }
};

}  // namespace

std::unique_ptr<Stage> make_read_stage() { return std::make_unique<ReadStage>(); }

}  // namespace foldwright
