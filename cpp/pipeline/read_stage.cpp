#include <algorithm>
#include <cmath>
#include <numeric>

#include "mesh/carry_origins.h"
#include "mesh/input_error.h"
#include "mesh/joints.h"
#include "mesh/nearest_face.h"
#include "mesh/read_model.h"
#include "mesh/simplify.h"
#include "mesh/turn_up.h"
#include "pipeline/counted.h"
#include "pipeline/edits.h"
#include "pipeline/recut_nets.h"
#include "pipeline/stage.h"

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
  const std::string looks = !soup.has_textures  ? "colours"
                            : !soup.has_colours ? "textures"
                                                : "colours and textures";
  state.notices.push_back(
      {"materials-ignored", "the model's " + looks + " are not printed: its paper is white"});
}

/// Tells which files came along that nothing is made of.
void tell_ignored(JobState& state) {
  constexpr std::size_t kMostNames = 3;  // a sentence with more is not read
  const std::size_t count = state.files.size();
  if (count == 0) return;
  std::string names;
  for (std::size_t i = 0; i < std::min(count, kMostNames); ++i) {
    const bool is_last = i + 1 == count;
    names += (i == 0 ? "" : is_last ? " and " : ", ") + state.files[i].name;
  }
  if (count > kMostNames) names += " and " + std::to_string(count - kMostNames) + " more";
  state.notices.push_back({"files-ignored", counted(static_cast<int>(count), "other file") +
                                                (count == 1 ? " was" : " were") +
                                                " not needed: " + names});
}

/// Reads the model among the files, frees it, and keeps the others.
PolygonSoup read_files(JobState& state) {
  const auto chosen = state.files.begin() + static_cast<std::ptrdiff_t>(find_model(state.files));
  const ModelFile model = std::move(*chosen);
  state.files.erase(chosen);
  state.result.file = model.name;
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
    state.notices.push_back({"up-guessed",
                             "the file does not say which way is up; the z axis was taken, as in "
                             "most files of this format"});
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
  state.result.simplified_deviation = largest_deviation(mesh, simple);
  simple.joints = find_joints(simple);
  if (const auto lost = static_cast<int>(mesh.joints.size() - simple.joints.size()); lost > 0) {
    state.notices.push_back({"joints-lost", counted(lost, "edge") +
                                                " that stood on other faces came loose when the "
                                                "model was simplified: glue by sight"});
  }
  if (simple.face_count() > wanted) {
    state.notices.push_back({"faces-above-wish", "simplifying stopped at " +
                                                     std::to_string(simple.face_count()) +
                                                     " faces: fewer would break the surface"});
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
    state.notices.push_back({"parts-raised", "the model has " + counted(least, "separate body") +
                                                 ", so it needs at least as many parts"});
  } else if (wanted > most) {
    state.notices.push_back({"parts-lowered", "the model has only " + counted(most, "flat panel") +
                                                  ", so it cannot have more parts"});
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
  const std::string time = seconds < 90 ? std::to_string(std::lround(seconds / 5) * 5) + " seconds"
                                        : std::to_string(std::lround(seconds / 60)) + " minutes";
  const std::string faces = std::to_string(kProposedFaces);
  const Notice notice{"large-model",
                      "the model has " + std::to_string(state.surface->mesh.face_count()) +
                          " faces: nets for them take about " + time +
                          ", and most of them will be too small to fold; simplified to " + faces +
                          " faces (--faces " + faces + ") it takes seconds"};
  state.notices.push_back(notice);
  events.push_back(notice);
}

/// From bytes to components: read, repair, simplify, dual graph.
class ReadStage : public Stage {
 public:
  StageId id() const override { return StageId::kRead; }

  void begin(JobState& state, TaskQueue&, Events& events) override {
    check_options(state.options);
    const PolygonSoup soup = read_upright(state);
    state.model = repair(soup);
    // At once, for what comes may take long, or fail.
    for (const auto& [code, count, text] : state.model.repairs) {
      events.push_back(Notice{code, text});
    }
    state.surface = make_surface(kModelSurface, simplified(state));
    events.push_back(ModelEvent{state.surface, state.result.file});
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
