#pragma once

#include <optional>

#include "unfold/net.h"

namespace foldwright {

/// The direction of the straight lines of a net, if it has many: an angle in [0, pi/2) to one of
/// which and to its perpendicular three lines or more run that make up 30 % of the length of all
/// its folds and cuts. Lines within flat panels do not count. Time: n log n in the edges.
std::optional<double> grain_of(const Net& net);

}  // namespace foldwright
