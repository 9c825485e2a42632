#pragma once

#include <array>

#include "pipeline/state.h"

namespace foldwright {

/// Cuts a net at one fold into two that keep all other folds, and the motion: what folds up without
/// collisions does so in two pieces, too.
///
/// `fold`: index into `net.folds`. Both halves get the cause `kSheet`. Linear.
std::array<FoundNet, 2> split_net(const Component& component, const FoundNet& net, int fold);

}  // namespace foldwright
