#include "pipeline/recut_nets.h"

#include <algorithm>
#include <cstdio>

#include "mesh/input_error.h"
#include "paper/recut.h"
#include "pipeline/flat_net.h"
#include "pipeline/net_split.h"

namespace foldwright {
namespace {

// Halvings of the range of scales that flaps leave open, a twentieth of the size: to a thousandth.
constexpr int kFlapTrials = 6;

Plates plates_of(const DualGraph& graph, const FoundNet& found, const Net& net) {
  Plates plates;
  for (int panel = 0; panel < graph.panel_count(); ++panel) {
    std::vector<Vec2>& corners = plates.corners.emplace_back();
    double& area = plates.areas.emplace_back(0);
    for (const int face : graph.panel_faces(panel)) {
      const auto slot = std::ranges::lower_bound(net.faces, face) - net.faces.begin();
      const auto& [a, b, c] = net.corners[slot];
      corners.insert(corners.end(), {net.vertices[a], net.vertices[b], net.vertices[c]});
      area += 0.5 * cross(net.vertices[b] - net.vertices[a], net.vertices[c] - net.vertices[a]);
    }
  }
  for (const int h : found.folds) plates.folds.push_back(graph.hinges[h].panels);
  return plates;
}

/// Says how large a sheet would have to be for a face that cannot be cut.
InputError too_large(const JobState& state, const Net& net) {
  double longest = 0;
  for (const NetEdge& edge : net.edges) {
    const auto& [a, b] = edge.vertices;
    longest = std::max(longest, (net.vertices[a] - net.vertices[b]).norm());
  }
  char text[160];
  std::snprintf(text, sizeof text,
                "at this size a single face, with an edge of %.0f mm, is larger than a sheet of "
                "%g x %g mm: choose larger paper or a smaller model",
                longest, state.options.sheet.width, state.options.sheet.height);
  return InputError("face-too-large", text);
}

/// The net, or what becomes of it when it is cut until every piece fits the sheet.
std::vector<FoundNet> cut_to_fit(const JobState& state, FoundNet found, double scale) {
  const Extent room = printable(state.options.sheet);
  std::vector<FoundNet> open = {std::move(found)};
  std::vector<FoundNet> done;
  while (!open.empty()) {
    FoundNet next = std::move(open.back());
    open.pop_back();
    const Net net = flatten(state, next, scale);
    if (fits_somehow(footprint_of(net).points(), room)) {
      done.push_back(std::move(next));
      continue;
    }
    if (next.folds.empty()) throw too_large(state, net);
    const Plates plates = plates_of(graph_of(state, next), next, net);
    auto halves =
        split_net(state.components[next.region.component], next, choose_cut(plates, room));
    // The first half is looked at first, so that pieces come in order.
    open.push_back(std::move(halves[1]));
    open.push_back(std::move(halves[0]));
  }
  return done;
}

/// The nets' outlines and area in model units.
std::vector<Footprint> bare_footprints(const JobState& state) {
  std::vector<Footprint> prints;
  for (const FoundNet& found : state.nets) {
    prints.push_back(footprint_of(flatten(state, found, 1)));
  }
  return prints;
}

}  // namespace

double fitting_scale(const JobState& state) {
  const std::vector<Footprint> prints = bare_footprints(state);
  const SheetOptions& sheet = state.options.sheet;
  double high = fitting_scale(prints, sheet);
  const FlapOptions& flaps = state.options.flaps;
  if (flaps.side == FlapSide::kNone) return high;
  const Extent room = printable(sheet);
  const auto fits_at = [&](double scale) {
    std::vector<Net> nets;
    for (const FoundNet& found : state.nets) nets.push_back(flatten(state, found, scale));
    const FlapPlan plan = place_flaps(state.surface->mesh, nets, flaps);
    for (std::size_t i = 0; i < nets.size(); ++i) {
      if (!fits_somehow(footprint_of(nets[i], plan.flaps[i]).points(), room)) return false;
    }
    return true;
  };
  if (fits_at(high)) return high;
  // A tiny sheet may hold no net with flaps on both sides; then they are kept off its edge.
  const double spare = 1 - 2 * flaps.shape.height / std::min(room.width, room.height);
  double low = high * std::max(spare, 0.5);
  for (int trial = 0; trial < kFlapTrials; ++trial) {
    const double middle = 0.5 * (low + high);
    (fits_at(middle) ? low : high) = middle;
  }
  return low;
}

std::vector<FoundNet> recut_nets(const JobState& state, std::vector<FoundNet> nets, double scale) {
  if (state.options.size.by == Sizing::kFit) return nets;
  std::vector<FoundNet> fitting;
  for (FoundNet& net : nets) {
    for (FoundNet& piece : cut_to_fit(state, std::move(net), scale)) {
      fitting.push_back(std::move(piece));
    }
  }
  return fitting;
}

}  // namespace foldwright
