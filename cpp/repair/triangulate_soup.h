#pragma once

#include <span>

#include "mesh/polygon_soup.h"
#include "repair/triangle_soup.h"

namespace foldwright {

/// Cuts the faces of a file into triangles over welded vertices.
///
/// `vertex_of` gives for each vertex of the file the one that stands for it in `positions`. Corners
/// that weld with their neighbour and spikes (a, b, a) vanish first; faces with fewer than three
/// corners left, and triangles that use a vertex twice, are left out. The triangles of a face
/// depend neither on the corner with which the file begins it nor on its winding, so that
/// duplicates stay duplicates, and the back of a face has the triangles of its front. \throw
/// InputError ("too-many-corners") for a face with more than 10,000 corners
TriangleSoup triangulate_soup(const PolygonSoup& soup, std::span<const int> vertex_of,
                              std::vector<Vec3> positions);

}  // namespace foldwright
