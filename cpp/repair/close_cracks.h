#pragma once

#include "repair/t_junctions.h"
#include "repair/triangle_soup.h"

namespace foldwright {

/// Joins borders that face each other across cracks up to `widest`, and never wider than a tenth of
/// the shortest edge at the vertices on either side.
///
/// Border vertices that near to each other are joined in the middle, where border edges at them run
/// along each other. Then border vertices are put on border edges across cracks. Only borders are
/// touched, and not where the two faces lie on each other, as the edges of sheets in layers do.
/// Returns how many edges lie on a border no longer. n log n.
ClosedCracks close_cracks(TriangleSoup& soup, double widest);

}  // namespace foldwright
