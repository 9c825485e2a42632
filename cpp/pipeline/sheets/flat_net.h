#pragma once

#include "pipeline/state.h"

namespace foldwright {

/// The dual graph of a net's faces, whose hinges its folds name.
DualGraph graph_of(const JobState& state, const FoundNet& found);

/// A net laid flat, `scale` millimetres per model unit.
Net flatten(const JobState& state, const FoundNet& found, double scale);

/// What a flat net takes up with its flaps.
Footprint footprint_of(const Net& net, std::span<const Flap> flaps = {});

}  // namespace foldwright
