#pragma once

#include <vector>

#include "pipeline/state.h"

namespace foldwright {

/// Gives the state further nets, in their order: of each only if none of its panels has a net by
/// then. Panels are labelled with the part of their net. For jobs that end early, whose parts may
/// be between an older and a newer net; linear in the panels.
void add_spare_nets(JobState& state, std::vector<FoundNet> nets);

}  // namespace foldwright
