#pragma once

#include "paper/labels.h"
#include "paper/strips.h"
#include "pipeline/sheets/paper_draft.h"
#include "pipeline/sheets/recut_nets.h"
#include "pipeline/sheets/sheet_saver.h"

namespace foldwright {

/// Nets of their finished size on sheets, with all that is drawn on them.
struct PaperPlan {
  PaperDraft draft;
  std::vector<Strip> strips;  ///< by id
  int taped = 0;              ///< edges that want a flap and have neither flap nor strip
  LabelPlan labels;
  /// A slightly smaller scale that would save sheets, mm per model unit, and what it needs.
  struct Smaller {
    double scale;
    int sheets;
  };
  std::optional<Smaller> smaller;
};

/// Scales the nets of a state as its options ask, cuts those again that are too large for the
/// sheet, adds flaps, packs them, adds strips and labels, and looks whether a little smaller it
/// would need fewer sheets; step by step.
///
/// Without a wish for a size the largest net just fits with its flaps, and nothing is cut. With
/// one, flaps stay within the sheet where a net fits it only without them. With a number of sheets
/// the scale is found by bisection, the largest that was tried and fits.
class PaperPlanner {
 public:
  /// `in_a_hurry`: take the first packing that comes up. The state must outlive this.
  explicit PaperPlanner(const JobState& state, bool in_a_hurry = false);

  /// Does some milliseconds of work; true when the plan is done.
  /// \throw InputError if margins leave nothing of the sheet, a single face does not fit it, a
  /// pinned piece cannot stay, or an option names what the model does not have
  bool step();

  /// In [0, 1].
  double progress() const { return progress_; }

  /// \pre `step` returned true; leaves this empty
  PaperPlan take() { return std::move(plan_); }

 private:
  enum class Phase { kScale, kSearch, kDraft, kStrips, kLabels, kSmaller };

  bool takes_too_many_sheets() const;
  void begin_search();
  void search();
  void draft_at(double scale, int effort);
  void lay_strips();
  void begin_labels();

  const JobState& state_;
  bool in_a_hurry_;
  Phase phase_ = Phase::kScale;
  double progress_ = 0;
  std::optional<ScaleFinder> scale_;
  /// Scales between which the search for a number of sheets goes on; `low` fits, if any.
  struct {
    double low = 0, high = 0;
    int trials = 0;
  } range_;
  std::optional<PaperDrafter> drafter_;
  std::optional<SheetObstacles> obstacles_;
  std::optional<LabelPlacer> labels_;
  std::optional<SheetSaver> saver_;
  std::vector<int> tape_;             ///< mesh edges to mark, ascending
  std::vector<Standings> standings_;  ///< per net, as they lie on their sheets
  std::vector<Seam> joints_;          ///< as the nets lie on their sheets
  PaperPlan plan_;
};

/// The plan, all at once.
PaperPlan plan_paper(const JobState& state, bool in_a_hurry = false);

/// Finds the scale in millimetres per model unit at which `plan_paper` would lay the nets of a
/// state out; with a number of sheets what a planner in a hurry comes to. Throws what that throws.
class FinishedScale {
 public:
  /// The state must outlive this.
  explicit FinishedScale(const JobState& state);

  /// Does some milliseconds of work; true when it is found.
  bool step();

  double scale() const { return scale_; }

 private:
  const JobState& state_;
  std::optional<ScaleFinder> finder_;
  std::optional<PaperPlanner> planner_;
  double scale_ = 1;
};

}  // namespace foldwright
