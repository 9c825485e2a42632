#pragma once

#include <vector>

#include "unfold/net.h"

namespace foldwright {

/// The closed walks along a net's cuts as vertex indices, without repeating the first: the outer
/// boundary first and counter-clockwise, then holes clockwise. A slit that opens by nothing is
/// walked there and back. Linear.
std::vector<std::vector<int>> boundary_walks(const Net& net);

}  // namespace foldwright
