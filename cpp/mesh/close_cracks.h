#pragma once

#include "mesh/t_junctions.h"
#include "mesh/triangle_soup.h"

namespace foldwright {

/// Joins borders that face each other across cracks up to `widest`, and never wider than a tenth of
/// the shortest edge at the vertices on either side.
///
/// Border edges whose both ends are that near to those of another one are joined with the nearest:
/// their ends move to the middle. Then border vertices are put on border edges across cracks. Only
/// borders are touched, and not where the two faces lie on each other, as the edges of sheets in
/// layers do. n log n. \pre no edge of a face is shorter than the welding left it
ClosedCracks close_cracks(TriangleSoup& soup, double widest);

}  // namespace foldwright
