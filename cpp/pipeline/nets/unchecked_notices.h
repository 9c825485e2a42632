#pragma once

#include <span>

#include "pipeline/state.h"

namespace foldwright {

/// Adds why pieces of the result may fold up or not without anybody knowing: one notice for each
/// reason, which names its pieces.
///
/// `nets`: those that the pieces were made of, in their order.
void add_unchecked_notices(JobState& state, std::span<const FoundNet> nets);

}  // namespace foldwright
