#pragma once

#include "mesh/triangle_soup.h"

namespace foldwright {

/// Closes cracks where a border edge faces a chain of shorter ones: border vertices that lie on the
/// inside of a border edge, within `tolerance`, are put on it and its face is cut accordingly.
///
/// A vertex is put on an edge only where this lets two border edges meet, so that sheets that
/// merely touch stay as they are. Returns the number of edges that were cut.
int close_t_junctions(TriangleSoup& soup, double tolerance);

}  // namespace foldwright
