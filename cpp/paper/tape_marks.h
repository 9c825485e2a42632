#pragma once

#include <array>
#include <vector>

#include "paper/label_space.h"
#include "paper/seams.h"

namespace foldwright {

/// Strokes on the two sides of a seam that say "join with tape": two short ones across the edge,
/// which meet their counterparts when the edges come together.
///
/// They stand at the same distance from the ends of the edge on both sides, as near to its middle
/// as both are clear of texts, 1.2 mm long or as long as the faces are high; none if texts leave no
/// such place. `spaces`: of the nets of the two sides.
std::array<std::vector<Stroke>, 2> tape_marks(const Seam& seam,
                                              std::array<const LabelSpace*, 2> spaces);

}  // namespace foldwright
