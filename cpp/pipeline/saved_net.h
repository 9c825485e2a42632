#pragma once

#include "mesh/input_error.h"
#include "pipeline/state.h"

namespace foldwright {

/// A net as plain values.
SavedNet save_net(const Component& component, const FoundNet& net);

/// Back from plain values, as a net that is kept; `component` is number `index` and has all of its
/// faces. The motion is taken on trust.
/// \throw InputError if it is no spanning tree of panels of the component
FoundNet load_net(const Component& component, int index, const SavedNet& saved);

/// What is said of an earlier result that cannot be of this model.
InputError foreign_start();

}  // namespace foldwright
