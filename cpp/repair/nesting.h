#pragma once

#include <span>
#include <utility>
#include <vector>

#include "repair/triangle_soup.h"

namespace foldwright {

/// Per body the outermost body that it lies in, -1 for one that lies in none.
///
/// A body lies in another one when both are closed, it does not cross it, and its inside is within
/// the other's. Bodies that touch from within lie in each other as well, up to a thousandth of the
/// extent. What is inside is found by counting surfaces along a line through the middle of the
/// body, so the cost is n log n for bodies side by side.
/// `bodies`: per face its body, from 0. `crossing`: pairs of bodies that cross, ascending.
/// \pre closed bodies are wound outwards
std::vector<int> find_nesting(const TriangleSoup& soup, std::span<const int> bodies,
                              std::span<const std::pair<int, int>> crossing);

}  // namespace foldwright
