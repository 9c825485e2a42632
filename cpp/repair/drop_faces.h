#pragma once

#include "repair/triangle_soup.h"

namespace foldwright {

/// Drops the faces that are not to be kept, and keeps the order of the others.
void keep_only(TriangleSoup& soup, const std::vector<char>& keep);

/// Drops triangles of an area up to `smallest_area`; keeps the order of the others.
void drop_degenerate(TriangleSoup& soup, double smallest_area);

/// Drops all but the first of triangles with the same corners in the same winding. Of two with
/// opposite winding both stay: they may be the two sides of a wall.
void drop_duplicates(TriangleSoup& soup);

}  // namespace foldwright
