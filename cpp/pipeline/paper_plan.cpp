#include "pipeline/paper_plan.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

#include "mesh/input_error.h"
#include "paper/gluing_order.h"
#include "paper/recut.h"
#include "pipeline/model_size.h"
#include "pipeline/net_split.h"

namespace foldwright {
namespace {

// Halvings of the range of scales for a number of sheets: finer than a hundredth of the size.
constexpr int kSheetTrials = 10;

// Halvings of the range of scales that flaps leave open, a twentieth of the size: to a thousandth.
constexpr int kFlapTrials = 6;

double triangle_area(const Triangle2& t) { return 0.5 * cross(t[1] - t[0], t[2] - t[0]); }

Footprint footprint_of(const Net& net, std::span<const Flap> flaps) {
  Footprint print;
  for (const auto& [a, b, c] : net.corners) {
    const Triangle2 face = {net.vertices[a], net.vertices[b], net.vertices[c]};
    print.polygons.push_back({face.begin(), face.end()});
    print.face_area += triangle_area(face);
  }
  for (const Flap& flap : flaps)
    print.polygons.push_back({flap.corners.begin(), flap.corners.end()});
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
    if (fits_somehow(footprint_of(net, {}).points(), room)) {
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

/// What keeps flaps on the sheet that the net fits: what is around the sheet when the net lies in
/// its middle, in the turn that leaves most room.
std::vector<std::vector<Vec2>> around_sheet(const Net& net, const Extent& room, double reach) {
  const std::vector<Vec2> hull = convex_hull(footprint_of(net, {}).points());
  std::optional<Turn> best;
  const auto spare = [&](const Turn& turn) {
    return std::min(room.width - turn.box.width, room.height - turn.box.height);
  };
  for (const Turn& turn : upright_turns(hull)) {
    if (!best || spare(turn) > spare(*best)) best = turn;
  }
  RigidMotion2 place = settle(hull, *best);
  place.t += 0.5 * Vec2(room.width - best->box.width, room.height - best->box.height);
  const RigidMotion2 back = place.inverse();
  const auto box = [&](double x0, double y0, double x1, double y1) {
    return std::vector<Vec2>{back({x0, y0}), back({x1, y0}), back({x1, y1}), back({x0, y1})};
  };
  const double width = room.width;
  const double height = room.height;
  return {box(-reach, -reach, 0, height + reach), box(width, -reach, width + reach, height + reach),
          box(-reach, -reach, width + reach, 0),
          box(-reach, height, width + reach, height + reach)};
}

/// Flaps for nets that fit the sheet, so that they fit it still.
FlapPlan flaps_on_sheets(const JobState& state, std::span<const Net> nets) {
  const FlapOptions& options = state.options.flaps;
  const Mesh& mesh = state.surface->mesh;
  const Extent room = printable(state.options.sheet);
  FlapPlan plan = place_flaps(mesh, nets, options);
  std::vector<std::vector<std::vector<Vec2>>> keep_off(nets.size());
  // Flaps that one net must do without may go to another, which then is looked at as well.
  for (bool fits_all = false; !fits_all;) {
    fits_all = true;
    for (std::size_t i = 0; i < nets.size(); ++i) {
      if (!keep_off[i].empty()) continue;
      if (fits_somehow(footprint_of(nets[i], plan.flaps[i]).points(), room)) continue;
      keep_off[i] = around_sheet(nets[i], room, 2 * options.shape.height);
      fits_all = false;
    }
    if (!fits_all) plan = place_flaps(mesh, nets, options, keep_off);
  }
  return plan;
}

void sort_for_gluing(PaperPlan& plan) {
  std::vector<FoundNet> nets;
  std::vector<Net> flat;
  for (const int i : gluing_order(plan.flat)) {
    nets.push_back(std::move(plan.nets[i]));
    flat.push_back(std::move(plan.flat[i]));
  }
  plan.nets = std::move(nets);
  plan.flat = std::move(flat);
}

PaperPlan plan_at(const JobState& state, double scale) {
  PaperPlan plan;
  for (const FoundNet& found : state.nets) {
    std::vector<FoundNet> pieces = {found};
    if (state.options.size.by != Sizing::kFit) pieces = cut_to_fit(state, found, scale);
    for (FoundNet& piece : pieces) {
      plan.flat.push_back(flatten(state, piece, scale));
      plan.nets.push_back(std::move(piece));
    }
  }
  sort_for_gluing(plan);
  plan.flaps = flaps_on_sheets(state, plan.flat);
  std::vector<Footprint> prints;
  for (std::size_t i = 0; i < plan.flat.size(); ++i) {
    prints.push_back(footprint_of(plan.flat[i], plan.flaps.flaps[i]));
  }
  plan.sheets = lay_on_sheets(prints, state.options.sheet);
  plan.sheets.scale = scale;
  for (std::size_t i = 0; i < plan.flat.size(); ++i) {
    for (Vec2& p : plan.flat[i].vertices) p = plan.sheets.turns[i](p);
    for (Flap& flap : plan.flaps.flaps[i]) {
      for (Vec2& p : flap.corners) p = plan.sheets.turns[i](p);
    }
  }
  return plan;
}

/// The nets' outlines and area in model units.
std::vector<Footprint> bare_footprints(const JobState& state) {
  std::vector<Footprint> prints;
  for (const FoundNet& found : state.nets) {
    prints.push_back(footprint_of(flatten(state, found, 1), {}));
  }
  return prints;
}

/// The largest scale at which every net fits with all the flaps it would have on an endless sheet.
double fitting_scale_with_flaps(const JobState& state) {
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

PaperPlan plan_size(const JobState& state) {
  const SizeOptions& size = state.options.size;
  switch (size.by) {
    case Sizing::kFit:
      return plan_at(state, fitting_scale_with_flaps(state));
    case Sizing::kSheets:
      return plan_on_sheets(state, static_cast<int>(size.value));
    default:
      return plan_at(state, fixed_scale(state.surface->mesh, size));
  }
}

}  // namespace

PaperPlan plan_paper(const JobState& state) {
  PaperPlan plan = plan_size(state);
  plan.labels = place_labels(plan.flat, plan.flaps.flaps, state.options.ids);
  return plan;
}

}  // namespace foldwright
