#include "pipeline/sheets/paper_draft.h"

#include <algorithm>

#include "paper/gluing_order.h"
#include "paper/pins.h"
#include "pipeline/sheets/flat_net.h"
#include "pipeline/sheets/small_bodies.h"

namespace foldwright {
namespace {

// Room between pieces for the numbers of both beside their edges, mm.
constexpr double kGapForIds = 6;

/// The upright turn of a net that leaves most room on the sheet.
Turn roomiest_turn(std::span<const Vec2> hull, const Extent& room) {
  const auto spare = [&](const Turn& turn) {
    return std::min(room.width - turn.box.width, room.height - turn.box.height);
  };
  return std::ranges::max(upright_turns(hull), {}, spare);
}

/// What keeps flaps on the sheet that the net fits: what is around the sheet when the net lies in
/// its middle, in a turn.
std::vector<std::vector<Vec2>> around_sheet(std::span<const Vec2> hull, const Turn& turn,
                                            const Extent& room, double reach) {
  RigidMotion2 place = turn_to_origin(hull, turn);
  place.t += 0.5 * Vec2(room.width - turn.box.width, room.height - turn.box.height);
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

void sort_for_gluing(PaperDraft& draft) {
  const std::vector<int> order = gluing_order(draft.flat);
  draft.nets = in_order(std::move(draft.nets), order);
  draft.flat = in_order(std::move(draft.flat), order);
}

}  // namespace

PaperDrafter::PaperDrafter(const JobState& state, double scale, int effort)
    : state_(state),
      scale_(scale),
      effort_(effort),
      cutter_(state, without_small_bodies(state, scale).printed, scale) {}

FitStep PaperDrafter::step() {
  switch (phase_) {
    case Phase::kCut: {
      const FitStep cut = cutter_.step();
      if (cut == FitStep::kDone) begin_pieces();
      return cut == FitStep::kDoesNotFit ? cut : FitStep::kRunning;
    }
    case Phase::kFlaps:
      if (place_flaps_on_sheets()) begin_packing();
      return FitStep::kRunning;
    case Phase::kPack:
      if (!pack()) return FitStep::kRunning;
      finish();
      return FitStep::kDone;
  }
  return FitStep::kDone;
}

void PaperDrafter::begin_pieces() {
  draft_.nets = cutter_.take();
  for (const FoundNet& net : draft_.nets) draft_.flat.push_back(flatten(state_, net, scale_));
  sort_for_gluing(draft_);
  for (const FoundNet& net : draft_.nets) parts_.push_back(net.region.part);
  draft_.names = piece_names(parts_, state_.parts.names);
  phase_ = Phase::kFlaps;
}

/// Flaps for nets that fit the sheet, so that they fit it still; false if some do not yet.
bool PaperDrafter::place_flaps_on_sheets() {
  const FlapOptions& options = state_.options.paper.flaps;
  const Extent room = printable(state_.options.paper.sheet);
  draft_.flaps =
      state_.memory->flaps.place(state_.model.surface->mesh, draft_.flat, options, keep_off_);
  keep_off_.resize(draft_.flat.size());
  held_.resize(draft_.flat.size());
  bool fits_all = true;
  for (std::size_t i = 0; i < draft_.flat.size(); ++i) {
    // Flaps that one net must do without may go to another, which then is looked at as well.
    if (!keep_off_[i].empty()) continue;
    if (fits_somehow(footprint_of(draft_.flat[i], draft_.flaps.flaps[i]), room)) continue;
    const std::vector<Vec2> hull = convex_hull(footprint_of(draft_.flat[i]).points());
    const Turn turn = roomiest_turn(hull, room);
    keep_off_[i] = around_sheet(hull, turn, room, 2 * options.shape.height);
    held_[i] = {turn.c, turn.s};
    fits_all = false;
  }
  return fits_all;
}

void PaperDrafter::begin_packing() {
  for (std::size_t i = 0; i < draft_.flat.size(); ++i) {
    draft_.prints.push_back(footprint_of(draft_.flat[i], draft_.flaps.flaps[i]));
    draft_.prints.back().fitting_turn = held_[i];
  }
  pins_.resize(draft_.nets.size());
  for (const PinnedPiece& pinned : state_.parts.pins) {
    const auto is_it = [&](std::size_t i) {
      return parts_[i] == pinned.part && draft_.flat[i].faces[0] == pinned.face;
    };
    bool is_found = false;
    for (std::size_t i = 0; i < pins_.size() && !is_found; ++i) {
      is_found = is_it(i);
      if (is_found) pins_[i] = pinned.pin;
    }
    if (!is_found) ++draft_.lost_pins;
  }
  hold_places();
  if (!holds_) planner_.emplace(sheet_task(pins_));
  phase_ = Phase::kPack;
}

SheetTask PaperDrafter::sheet_task(std::span<const std::optional<Pin>> pins) const {
  SheetTask task = {draft_.prints, state_.options.paper.sheet, parts_, pins, draft_.names, effort_};
  task.pin_play = state_.options.paper.flaps.shape.height;
  if (state_.options.paper.ids == IdPlace::kOutside) {
    task.options.gap = std::max(task.options.gap, kGapForIds);
  }
  return task;
}

/// Tries to leave nets where they lay in the earlier result, unless flaps run into each other
/// there.
void PaperDrafter::hold_places() {
  const EarlierPaper* earlier = earlier_paper(state_);
  if (!earlier || earlier->scale != scale_) return;
  held_pins_ = pins_;
  for (std::size_t i = 0; i < held_pins_.size(); ++i) {
    const auto& place = draft_.nets[i].place;
    if (held_pins_[i] || !place) continue;
    held_pins_[i] = pin_at(draft_.prints[i], place->sheet, place->motion);
  }
  SheetTask task = sheet_task(held_pins_);
  const bool is_upright = earlier->sheet_width <= task.options.width;
  task.options.orientation = is_upright ? Orientation::kPortrait : Orientation::kLandscape;
  if (!drop_clashing_pins(task, pins_, held_pins_)) return;
  holds_ = true;
  planner_.emplace(task);
}

/// True when the pieces are packed; nets that stay must not cost paper.
bool PaperDrafter::pack() {
  if (!planner_->step()) return false;
  draft_.sheets = planner_->take();
  if (!holds_ || draft_.sheets.sheet_count <= earlier_paper(state_)->sheets) return true;
  holds_ = false;
  planner_.emplace(sheet_task(pins_));
  return false;
}

void PaperDrafter::finish() {
  draft_.sheets.scale = scale_;
  for (std::size_t i = 0; i < draft_.flat.size(); ++i) {
    const RigidMotion2& turn = draft_.sheets.turns[i];
    for (Vec2& p : draft_.flat[i].vertices) p = turn(p);
    for (auto& polygon : draft_.prints[i].polygons) {
      for (Vec2& p : polygon) p = turn(p);
    }
    for (Flap& flap : draft_.flaps.flaps[i]) {
      for (Vec2& p : flap.corners) p = turn(p);
    }
  }
}

}  // namespace foldwright
