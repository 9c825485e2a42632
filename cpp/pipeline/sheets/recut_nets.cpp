#include "pipeline/sheets/recut_nets.h"

#include <algorithm>
#include <cmath>

#include "mesh/input_error.h"
#include "paper/gluing_order.h"
#include "paper/recut.h"
#include "pipeline/nets/net_split.h"
#include "pipeline/sheets/flat_net.h"
#include "pipeline/sheets/model_size.h"
#include "segment/lock_labels.h"

namespace foldwright {
namespace {

// Halvings of the range of scales that flaps leave open, a twentieth of the size: to a thousandth.
constexpr int kFlapTrials = 6;

// Pieces that lie along the sheet are worth a tenth of their size.
constexpr double kWorthStraight = 0.9;

/// The plates of a net between the folds that may be cut, and these as indices into its folds.
struct CuttablePlates {
  Plates plates;
  std::vector<int> folds;
};

CuttablePlates plates_of(const DualGraph& graph, const FoundNet& found, const Net& net) {
  const Labels plate_of = renumbered(locked_groups(graph));
  CuttablePlates cuttable;
  Plates& plates = cuttable.plates;
  plates.corners.resize(part_count(plate_of));
  plates.areas.resize(plates.corners.size(), 0);
  for (int panel = 0; panel < graph.panel_count(); ++panel) {
    std::vector<Vec2>& corners = plates.corners[plate_of[panel]];
    double& area = plates.areas[plate_of[panel]];
    for (const int face : graph.panel_faces(panel)) {
      const auto slot = std::ranges::lower_bound(net.faces, face) - net.faces.begin();
      const auto& [a, b, c] = net.corners[slot];
      corners.insert(corners.end(), {net.vertices[a], net.vertices[b], net.vertices[c]});
      area += 0.5 * cross(net.vertices[b] - net.vertices[a], net.vertices[c] - net.vertices[a]);
    }
  }
  for (std::size_t fold = 0; fold < found.folds.size(); ++fold) {
    const Hinge& hinge = graph.hinges[found.folds[fold]];
    if (hinge.stays_fold) continue;
    plates.folds.push_back({plate_of[hinge.panels[0]], plate_of[hinge.panels[1]]});
    cuttable.folds.push_back(static_cast<int>(fold));
  }
  return cuttable;
}

/// Says by how much a face that cannot be cut is too large for the sheet.
InputError too_large(const JobState& state, const Net& net) {
  const Footprint print = footprint_of(net);
  // As a person would measure it with a ruler: the smallest box around it.
  const auto area = [](const Turn& turn) { return turn.box.width * turn.box.height; };
  const Extent box = std::ranges::min(upright_turns(convex_hull(print.points())), {}, area).box;
  const double share = fitting_scale(std::span(&print, 1), state.options.paper.sheet);
  return InputError(kFaceTooLarge, {{"face_width_mm", std::max(box.width, box.height)},
                                    {"face_height_mm", std::min(box.width, box.height)},
                                    {"width_mm", state.options.paper.sheet.width},
                                    {"height_mm", state.options.paper.sheet.height},
                                    {"share", share}});
}

/// The nets' outlines and area in model units.
std::vector<Footprint> bare_footprints(const JobState& state) {
  std::vector<Footprint> prints;
  for (const FoundNet& found : state.nets.found) {
    prints.push_back(footprint_of(flatten(state, found, 1)));
  }
  return prints;
}

/// Whether a panel is longer than the sheet's shorter side anywhere, so that it may not fit.
bool is_long(const DualGraph& graph, int panel, double length) {
  const auto triangles = graph.panel_triangles(panel);
  const Vec2& from = triangles[0][0];
  return std::ranges::any_of(triangles, [&](const Triangle2& triangle) {
    return std::ranges::any_of(triangle,
                               [&](const Vec2& p) { return 2 * (p - from).norm() > length; });
  });
}

}  // namespace

void check_panels_fit(const JobState& state) {
  const SizeOptions& size = state.options.paper.size;
  if (size.by == Sizing::kFit || size.by == Sizing::kSheets) return;
  const Mesh& mesh = state.model.surface->mesh;
  const DualGraph& graph = state.model.surface->graph;
  const double scale = fixed_scale(mesh, size);
  const Extent room = printable(state.options.paper.sheet);
  const double shorter = std::min(room.width, room.height) / scale;
  for (int panel = 0; panel < graph.panel_count(); ++panel) {
    if (!is_long(graph, panel, shorter)) continue;
    Net net = make_net(mesh, restrict_to(graph, std::span(&panel, 1)), {});
    for (Vec2& p : net.vertices) p *= scale;
    if (!fits_somehow(footprint_of(net), room)) throw too_large(state, net);
  }
}

ScaleFinder::ScaleFinder(const JobState& state) : state_(state) {
  const std::vector<Footprint> prints = bare_footprints(state);
  high_ = fitting_scale(prints, state.options.paper.sheet);
  const Extent room = printable(state.options.paper.sheet);
  // A tiny sheet may hold no net with flaps on both sides; then they are kept off its edge.
  const double spare =
      1 - 2 * state.options.paper.flaps.shape.height / std::min(room.width, room.height);
  low_ = high_ * std::max(spare, 0.5);
  const EarlierPaper* earlier = earlier_paper(state);
  if (earlier && earlier->scale < high_) {
    high_ = earlier->scale;
    low_ = std::min(low_, high_);
  }
  // What was laid out once keeps its size.
  may_straighten_ = !earlier && std::ranges::any_of(prints, [](const Footprint& print) {
    return print.grain.has_value();
  });
}

bool ScaleFinder::step() {
  if (is_straight_) return step_straight();
  if (!step_freely()) return false;
  if (!may_straighten_) return true;
  is_straight_ = true;
  free_ = high_ = low_;
  low_ = kWorthStraight * free_;
  trials_ = -2;
  return false;
}

/// Of the largest and the smallest scale that would do first.
bool ScaleFinder::step_straight() {
  if (trials_ == -2 && fits_at(high_)) {
    low_ = high_;
    return true;
  }
  if (trials_ == -1 && !fits_at(low_)) {
    low_ = free_;
    return true;
  }
  if (trials_ >= 0) {
    const double middle = 0.5 * (low_ + high_);
    (fits_at(middle) ? low_ : high_) = middle;
  }
  return ++trials_ == kFlapTrials;
}

bool ScaleFinder::step_freely() {
  if (trials_ == 0 && fits_at(high_)) {
    low_ = high_;
    return true;
  }
  const double middle = 0.5 * (low_ + high_);
  (fits_at(middle) ? low_ : high_) = middle;
  return ++trials_ == kFlapTrials;
}

bool ScaleFinder::fits_at(double scale) const {
  std::vector<Net> nets;
  for (const FoundNet& found : state_.nets.found) nets.push_back(flatten(state_, found, scale));
  // In the order in which they are laid out at the scale that is found: they need not be placed
  // once more then, nor after an edit that leaves nets and scale as they are.
  const std::vector<int> order = gluing_order(nets);
  nets = in_order(std::move(nets), order);
  const FlapPlan plan =
      state_.memory->flaps.place(state_.model.surface->mesh, nets, state_.options.paper.flaps);
  const Extent room = printable(state_.options.paper.sheet);
  for (std::size_t i = 0; i < nets.size(); ++i) {
    const Footprint print = footprint_of(nets[i], plan.flaps[i]);
    if (!(is_straight_ ? fits_straight(print, room) : fits_somehow(print, room))) return false;
  }
  return true;
}

NetCutter::NetCutter(const JobState& state, std::vector<FoundNet> nets, double scale)
    : state_(state), scale_(scale), open_(std::move(nets)) {
  if (state.options.paper.size.by == Sizing::kFit) {
    fitting_ = std::move(open_);
    open_.clear();
  }
  std::ranges::reverse(open_);
}

FitStep NetCutter::step() {
  if (open_.empty()) return FitStep::kDone;
  FoundNet next = std::move(open_.back());
  open_.pop_back();
  const Extent room = printable(state_.options.paper.sheet);
  const Net net = flatten(state_, next, scale_);
  if (fits_somehow(footprint_of(net), room)) {
    fitting_.push_back(std::move(next));
    return open_.empty() ? FitStep::kDone : FitStep::kRunning;
  }
  const auto [plates, folds] = plates_of(graph_of(state_, next), next, net);
  if (folds.empty()) {
    misfit_ = too_large(state_, net);
    return FitStep::kDoesNotFit;
  }
  const int fold = folds[choose_cut(plates, room)];
  auto halves = split_net(state_.parts.components[next.region.component], next, fold);
  // The first half is looked at first, so that pieces come in order.
  open_.push_back(std::move(halves[1]));
  open_.push_back(std::move(halves[0]));
  return FitStep::kRunning;
}

std::vector<FoundNet> recut_nets(const JobState& state, std::vector<FoundNet> nets, double scale) {
  NetCutter cutter(state, std::move(nets), scale);
  FitStep step = FitStep::kRunning;
  while (step == FitStep::kRunning) step = cutter.step();
  if (step == FitStep::kDoesNotFit) throw cutter.misfit();
  return cutter.take();
}

}  // namespace foldwright
