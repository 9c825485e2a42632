#pragma once

#include "pipeline/state.h"

namespace foldwright {

/// The largest scale in millimetres per model unit at which every net of a state fits a sheet, with
/// all the flaps that it would have if sheets had no end.
/// \throw InputError if margins leave nothing of the sheet
double fitting_scale(const JobState& state);

/// Cuts nets again until every piece fits the sheet; nets that fit stay as they are, and so do all
/// where the size asked for is the one that fits. In the order of the nets.
///
/// `scale`: millimetres per model unit.
/// \throw InputError if margins leave nothing of the sheet, or a single face does not fit it
std::vector<FoundNet> recut_nets(const JobState& state, std::vector<FoundNet> nets, double scale);

}  // namespace foldwright
