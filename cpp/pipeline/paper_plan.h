#pragma once

#include "pipeline/state.h"

namespace foldwright {

/// Nets of their finished size on sheets.
struct PaperPlan {
  /// Those of the state in the order of gluing, some of them cut again.
  std::vector<FoundNet> nets;
  std::vector<Net> flat;  ///< per net: in millimetres, turned, its box from (0, 0)
  FlapPlan flaps;         ///< where the nets lie
  SheetLayout sheets;
  LabelPlan labels;
};

/// Scales the nets of a state as its options ask, cuts those again that are too large for the
/// sheet, adds flaps, and lays them out.
///
/// Without a wish for a size the largest net just fits with its flaps, and nothing is cut. With
/// one, flaps stay within the sheet where a net fits it only without them. With a number of sheets
/// the scale is found by bisection, the largest that was tried and fits.
/// \throw InputError if margins leave nothing of the sheet, or a single face does not fit it
PaperPlan plan_paper(const JobState& state);

/// The scale in millimetres per model unit at which `plan_paper` would lay the nets of a state out.
/// With a number of sheets as costly as the plan. Throws what it throws.
double finished_scale(const JobState& state);

}  // namespace foldwright
