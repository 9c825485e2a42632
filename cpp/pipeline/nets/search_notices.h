#pragma once

#include "pipeline/state.h"

namespace foldwright {

/// Adds what a person should know of the nets: parts that became several pieces and why, and those
/// that do not fold up without collisions.
void add_search_notices(JobState& state);

}  // namespace foldwright
