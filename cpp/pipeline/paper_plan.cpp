#include "pipeline/paper_plan.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

#include "mesh/input_error.h"
#include "paper/recut.h"
#include "pipeline/model_size.h"
#include "pipeline/net_split.h"

namespace foldwright {
namespace {

// Halvings of the range of scales for a number of sheets: finer than a hundredth of the size.
constexpr int kSheetTrials = 10;

double triangle_area(const Triangle2& t) { return 0.5 * cross(t[1] - t[0], t[2] - t[0]); }

Footprint footprint_of(const Net& net) {
  Footprint print;
  for (const auto& [a, b, c] : net.corners) {
    const Triangle2 face = {net.vertices[a], net.vertices[b], net.vertices[c]};
    print.polygons.push_back({face.begin(), face.end()});
    print.face_area += triangle_area(face);
  }
  return print;
}

DualGraph graph_of(const JobState& state, const FoundNet& net) {
  return restrict_to(state.components[net.region.component].graph, net.region.panels);
}

Net flatten(const JobState& state, const FoundNet& found, double scale) {
  Net net = make_net(state.surface->mesh, graph_of(state, found), found.folds);
  for (Vec2& p : net.vertices) p *= scale;
  return net;
}

Plates plates_of(const DualGraph& graph, const FoundNet& found, const Net& net) {
  Plates plates;
  for (int panel = 0; panel < graph.panel_count(); ++panel) {
    std::vector<Vec2>& corners = plates.corners.emplace_back();
    double& area = plates.areas.emplace_back(0);
    for (const int face : graph.panel_faces(panel)) {
      const auto slot = std::ranges::lower_bound(net.faces, face) - net.faces.begin();
      const auto& [a, b, c] = net.corners[slot];
      corners.insert(corners.end(), {net.vertices[a], net.vertices[b], net.vertices[c]});
      area += triangle_area({net.vertices[a], net.vertices[b], net.vertices[c]});
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

PaperPlan plan_at(const JobState& state, double scale) {
  PaperPlan plan;
  std::vector<Footprint> prints;
  for (const FoundNet& found : state.nets) {
    std::vector<FoundNet> pieces = {found};
    if (state.options.size.by != Sizing::kFit) pieces = cut_to_fit(state, found, scale);
    for (FoundNet& piece : pieces) {
      plan.flat.push_back(flatten(state, piece, scale));
      prints.push_back(footprint_of(plan.flat.back()));
      plan.nets.push_back(std::move(piece));
    }
  }
  plan.sheets = lay_on_sheets(prints, state.options.sheet);
  plan.sheets.scale = scale;
  for (std::size_t i = 0; i < plan.flat.size(); ++i) {
    for (Vec2& p : plan.flat[i].vertices) p = plan.sheets.turns[i](p);
  }
  return plan;
}

/// The nets' outlines and area in model units.
std::vector<Footprint> bare_footprints(const JobState& state) {
  std::vector<Footprint> prints;
  for (const FoundNet& found : state.nets) {
    prints.push_back(footprint_of(flatten(state, found, 1)));
  }
  return prints;
}

/// The plan at the largest scale that goes on so many sheets.
PaperPlan plan_on_sheets(const JobState& state, int sheets) {
  const std::vector<Footprint> prints = bare_footprints(state);
  const Extent room = printable(state.options.sheet);
  double area = 0;
  for (const Footprint& print : prints) area += print.face_area;
  double high = std::sqrt(sheets * room.width * room.height / area);
  std::optional<PaperPlan> best;
  // A face that fits no sheet at the larger scale counts as too large as well.
  const auto attempt = [&](double scale) {
    try {
      PaperPlan plan = plan_at(state, scale);
      if (plan.sheets.sheet_count > sheets) return false;
      best = std::move(plan);
      return true;
    } catch (const InputError&) {
      return false;
    }
  };
  double low = high / 2;
  while (!attempt(low)) high = low, low /= 2;
  for (int trial = 0; trial < kSheetTrials; ++trial) {
    const double middle = 0.5 * (low + high);
    (attempt(middle) ? low : high) = middle;
  }
  return std::move(*best);
}

}  // namespace

PaperPlan plan_paper(const JobState& state) {
  const SizeOptions& size = state.options.size;
  switch (size.by) {
    case Sizing::kFit:
      return plan_at(state, fitting_scale(bare_footprints(state), state.options.sheet));
    case Sizing::kSheets:
      return plan_on_sheets(state, static_cast<int>(size.value));
    default:
      return plan_at(state, fixed_scale(state.surface->mesh, size));
  }
}

}  // namespace foldwright
