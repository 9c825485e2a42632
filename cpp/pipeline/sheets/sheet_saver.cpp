#include "pipeline/sheets/sheet_saver.h"

namespace foldwright {
namespace {

// A model that is smaller by more is another model.
constexpr double kLeastShare = 0.95;

// Scales that are tried at most: to half a hundredth of the size.
constexpr int kTrials = 4;

// Packings that are tried at each of them.
constexpr int kTrialEffort = 6;

constexpr std::size_t kMostPieces = 50;

bool is_likely(const JobState& state, const SheetLayout& layout) {
  return state.options.paper.size.by != Sizing::kSheets && layout.sheet_count > 1 &&
         layout.used_height < 0.5 * layout.sheet_height &&
         layout.placements.size() <= kMostPieces && state.parts.pins.empty();
}

}  // namespace

SheetSaver::SheetSaver(const JobState& state, const SheetLayout& layout)
    : state_(state), high_(layout.scale), most_(layout.sheet_count - 1) {
  if (is_likely(state, layout)) begin(kLeastShare * high_);
}

void SheetSaver::begin(double scale) {
  tried_ = scale;
  drafter_.emplace(state_, scale, kTrialEffort);
}

bool SheetSaver::step() {
  if (!drafter_) return true;
  const FitStep step = drafter_->step();
  if (step == FitStep::kRunning) return false;
  const int sheets = step == FitStep::kDone ? drafter_->take().sheets.sheet_count : most_ + 1;
  drafter_.reset();
  if (sheets <= most_) {
    found_ = tried_;
    sheets_ = sheets;
  } else {
    high_ = tried_;
  }
  if (!found_ || ++trials_ == kTrials) return true;
  begin(0.5 * (*found_ + high_));
  return false;
}

}  // namespace foldwright
