#include "pipeline/sheets/paper_plan.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "mesh/input_error.h"
#include "paper/outer_names.h"
#include "paper/seam_ids.h"
#include "pipeline/sheets/flat_net.h"
#include "pipeline/sheets/model_size.h"

namespace foldwright {
namespace {

// Halvings of the range of scales for a number of sheets: finer than a hundredth of the size.
constexpr int kSheetTrials = 10;

// Halvings until a scale is found that goes on so many sheets. What does not go on at a
// millionth of the size is held up by something else, and is told.
constexpr int kMostHalvings = 20;

// Packings that are tried at each scale on the way to a number of sheets.
constexpr int kTrialEffort = 6;

/// Mesh edges that are to be joined by strips or tape, ascending: those that miss a flap, and all
/// if strips are to do without any flaps.
std::vector<int> bare_edges(const PaperOptions& options, const FlapPlan& flaps,
                            std::span<const Seam> seams) {
  std::set<int> bare;
  for (const MissedFlap& miss : flaps.missed) bare.insert(miss.mesh_edge);
  if (options.flaps.side == FlapSide::kNone && options.strips != GlueStrips::kNone) {
    for (const Seam& seam : seams) {
      if (seam.sides[0].length() > kWantedLength) bare.insert(seam.mesh_edge());
    }
  }
  return {bare.begin(), bare.end()};
}

}  // namespace

PaperPlanner::PaperPlanner(const JobState& state, bool in_a_hurry)
    : state_(state), in_a_hurry_(in_a_hurry) {
  if (state.options.paper.size.by == Sizing::kFit) scale_.emplace(state);
}

bool PaperPlanner::step() {
  const int effort = in_a_hurry_ ? 1 : SheetTask::kFullEffort;
  switch (phase_) {
    case Phase::kScale:
      if (const EarlierPaper* earlier = earlier_paper(state_);
          earlier && state_.options.paper.size.by == Sizing::kSheets) {
        draft_at(earlier->scale, effort);
      } else if (state_.options.paper.size.by == Sizing::kSheets) {
        begin_search();
      } else if (!scale_) {
        draft_at(fixed_scale(state_.model.surface->mesh, state_.options.paper.size), effort);
      } else if (scale_->step()) {
        draft_at(scale_->scale(), effort);
      }
      return false;
    case Phase::kSearch:
      search();
      return false;
    case Phase::kDraft:
      switch (drafter_->step()) {
        case FitStep::kRunning:
          return false;
        case FitStep::kDoesNotFit:
          throw drafter_->misfit();
        case FitStep::kDone:
          break;
      }
      plan_.draft = drafter_->take();
      if (takes_too_many_sheets()) {
        begin_search();
        return false;
      }
      phase_ = Phase::kStrips;
      progress_ = 0.6;
      return false;
    case Phase::kStrips:
      lay_strips();
      begin_labels();
      return false;
    case Phase::kLabels:
      if (!labels_->step()) return false;
      plan_.labels = labels_->take();
      write_outer_names({*obstacles_, plan_.draft.names}, plan_.labels);
      progress_ = 0.9;
      if (in_a_hurry_ || earlier_paper(state_)) return true;
      saver_.emplace(state_, plan_.draft.sheets);
      phase_ = Phase::kSmaller;
      return false;
    case Phase::kSmaller:
      if (!saver_->step()) return false;
      if (const auto scale = saver_->scale()) plan_.smaller = {*scale, saver_->sheets()};
      progress_ = 1;
      return true;
  }
  return true;
}

/// Whether the size of the earlier result does for the number of sheets no longer.
bool PaperPlanner::takes_too_many_sheets() const {
  return range_.high == 0 && state_.options.paper.size.by == Sizing::kSheets &&
         plan_.draft.sheets.sheet_count > static_cast<int>(state_.options.paper.size.value);
}

void PaperPlanner::begin_search() {
  const Extent room = printable(state_.options.paper.sheet);
  double area = 0;
  for (const FoundNet& found : state_.nets.found)
    area += footprint_of(flatten(state_, found, 1)).face_area;
  range_.high = std::sqrt(state_.options.paper.size.value * room.width * room.height / area);
  drafter_.emplace(state_, range_.high / 2, in_a_hurry_ ? 1 : kTrialEffort);
  phase_ = Phase::kSearch;
}

/// One step of the search for the largest scale that goes on so many sheets.
void PaperPlanner::search() {
  const double tried = range_.low > 0 ? 0.5 * (range_.low + range_.high) : range_.high / 2;
  const FitStep step = drafter_->step();
  if (step == FitStep::kRunning) return;
  // A face that fits no sheet at this scale counts as too large as well.
  const bool fits = step == FitStep::kDone && drafter_->take().sheets.sheet_count <=
                                                  static_cast<int>(state_.options.paper.size.value);
  if (range_.low == 0 && !fits && range_.trials == kMostHalvings) {
    if (step == FitStep::kDoesNotFit) throw drafter_->misfit();
    throw InputError("too-few-sheets");
  }
  ++range_.trials;
  if (range_.low > 0) progress_ = 0.5 * range_.trials / kSheetTrials;
  if (range_.low == 0 && fits) range_.trials = 0;
  (fits ? range_.low : range_.high) = tried;
  const int effort = in_a_hurry_ ? 1 : kTrialEffort;
  if (range_.low > 0 && range_.trials == kSheetTrials) {
    // More packings include those that found this scale.
    draft_at(range_.low, in_a_hurry_ ? 1 : SheetTask::kFullEffort);
  } else {
    const double next = range_.low > 0 ? 0.5 * (range_.low + range_.high) : range_.high / 2;
    drafter_.emplace(state_, next, effort);
  }
}

void PaperPlanner::draft_at(double scale, int effort) {
  drafter_.emplace(state_, scale, effort);
  phase_ = Phase::kDraft;
  progress_ = std::max(progress_, 0.1);
}

void PaperPlanner::lay_strips() {
  const PaperDraft& draft = plan_.draft;
  const PaperOptions& options = state_.options.paper;
  const std::vector<Seam> seams = find_seams(draft.flat);
  const std::vector<int> bare = bare_edges(options, draft.flaps, seams);
  std::set<int> open(bare.begin(), bare.end());
  if (options.strips != GlueStrips::kNone) {
    const std::vector<SeamId> ids = name_seams(draft.flat, draft.names, seams);
    std::vector<StripShape> shapes;
    std::vector<Strip> strips;
    for (std::size_t i = 0; i < seams.size(); ++i) {
      if (!open.contains(seams[i].mesh_edge())) continue;
      const auto shape = make_strip(seams[i], ids[i].name, options.flaps.shape.angles[0]);
      if (!shape) continue;
      shapes.push_back(*shape);
      Strip& strip = strips.emplace_back();
      strip.mesh_edge = seams[i].mesh_edge();
      strip.id = ids[i].name;
      strip.angle = fold_angle(state_.model.surface->mesh, seams[i].mesh_edge());
    }
    plan_.strips = place_strips(
        {draft.prints, &draft.sheets, options.sheet, options.strips == GlueStrips::kAll}, shapes,
        std::move(strips));
    int count = draft.sheets.sheet_count;
    for (const Strip& strip : plan_.strips) {
      open.erase(strip.mesh_edge);
      count = std::max(count, strip.sheet + 1);
    }
    SheetLayout& layout = plan_.draft.sheets;
    layout.efficiency *= static_cast<double>(layout.sheet_count) / count;
    layout.sheet_count = count;
  }
  plan_.taped = static_cast<int>(open.size());
  tape_.assign(open.begin(), open.end());
}

void PaperPlanner::begin_labels() {
  const PaperDraft& draft = plan_.draft;
  joints_ = find_joint_seams(state_.model.surface->mesh, draft.flat);
  const Surface& surface = *state_.model.surface;
  std::vector<Contact> contacts = find_contacts(surface.mesh, surface.graph);
  // What is not printed stands nowhere.
  std::erase_if(contacts, [&](const Contact& contact) {
    return std::ranges::none_of(draft.flat, [&](const Net& net) {
      return std::ranges::binary_search(net.faces, contact.guest);
    });
  });
  for (const Net& net : draft.flat) {
    standings_.push_back(standings_on(surface.mesh, net, contacts));
  }
  obstacles_.emplace(draft.prints, draft.sheets, state_.options.paper.sheet, plan_.strips);
  labels_.emplace(LabelTask{draft.flat, draft.flaps.flaps, draft.names, state_.options.paper.ids,
                            tape_, joints_, &state_.memory->texts, &*obstacles_, standings_});
  phase_ = Phase::kLabels;
  progress_ = 0.8;
}

PaperPlan plan_paper(const JobState& state, bool in_a_hurry) {
  PaperPlanner planner(state, in_a_hurry);
  while (!planner.step()) {
  }
  return planner.take();
}

FinishedScale::FinishedScale(const JobState& state) : state_(state) {
  if (state.options.paper.size.by == Sizing::kFit) finder_.emplace(state);
  if (state.options.paper.size.by == Sizing::kSheets) planner_.emplace(state, true);
}

bool FinishedScale::step() {
  if (finder_) {
    if (!finder_->step()) return false;
    scale_ = finder_->scale();
  } else if (planner_) {
    if (!planner_->step()) return false;
    scale_ = planner_->take().draft.sheets.scale;
  } else {
    scale_ = fixed_scale(state_.model.surface->mesh, state_.options.paper.size);
  }
  return true;
}

}  // namespace foldwright
