#include "pipeline/paper_plan.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "mesh/input_error.h"
#include "paper/gluing_order.h"
#include "pipeline/flat_net.h"
#include "pipeline/model_size.h"
#include "pipeline/recut_nets.h"

namespace foldwright {
namespace {

// Halvings of the range of scales for a number of sheets: finer than a hundredth of the size.
constexpr int kSheetTrials = 10;

/// What keeps flaps on the sheet that the net fits: what is around the sheet when the net lies in
/// its middle, in the turn that leaves most room.
std::vector<std::vector<Vec2>> around_sheet(const Net& net, const Extent& room, double reach) {
  const std::vector<Vec2> hull = convex_hull(footprint_of(net).points());
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
  plan.nets = recut_nets(state, state.nets, scale);
  for (const FoundNet& found : plan.nets) plan.flat.push_back(flatten(state, found, scale));
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

/// The plan at the largest scale that goes on so many sheets.
PaperPlan plan_on_sheets(const JobState& state, int sheets) {
  const Extent room = printable(state.options.sheet);
  double area = 0;
  for (const FoundNet& found : state.nets) area += footprint_of(flatten(state, found, 1)).face_area;
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
      return plan_at(state, fitting_scale(state));
    case Sizing::kSheets:
      return plan_on_sheets(state, static_cast<int>(size.value));
    default:
      return plan_at(state, fixed_scale(state.surface->mesh, size));
  }
}

}  // namespace

double finished_scale(const JobState& state) {
  switch (state.options.size.by) {
    case Sizing::kFit:
      return fitting_scale(state);
    case Sizing::kSheets:
      return plan_size(state).sheets.scale;
    default:
      return fixed_scale(state.surface->mesh, state.options.size);
  }
}

PaperPlan plan_paper(const JobState& state) {
  PaperPlan plan = plan_size(state);
  plan.labels = place_labels(plan.flat, plan.flaps.flaps, state.options.ids);
  return plan;
}

}  // namespace foldwright
