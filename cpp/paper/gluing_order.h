#pragma once

#include <span>
#include <vector>

#include "unfold/net.h"

namespace foldwright {

/// The order in which nets become the model: the largest first, then always the one with the
/// longest border to what is already together, so that every piece finds firm ground; of pieces
/// without one the largest, of equals the first. Indices of nets.
std::vector<int> gluing_order(std::span<const Net> nets);

}  // namespace foldwright
