#pragma once

#include <vector>

#include "repair/triangle_soup.h"

namespace foldwright {

/// The faces that were drawn in one plane: what the file's precision hides of it is made up for.
using DrawnPlanes = std::vector<std::vector<int>>;

/// Groups the faces of a manifold into planes, as connected as possible; each plane's faces are
/// ascending, the planes in order of their lowest face. Planes of a single face are left out.
///
/// Triangles of one polygon of the file lie in one plane when their corners leave it by what the
/// errors of the vertices explain, up to a twentieth of the polygon's extent, or by a thousandth of
/// its extent: people draw quads that are not quite flat and mean them to be. Otherwise planes grow
/// from the largest face over edges: a neighbour belongs to it when all its corners are as far off
/// the first face's plane as errors explain, extrapolated from that face's corners, and it is
/// tilted by a degree at most, so that gentle creases stay. The tilt of needles that are thinner
/// than the errors says nothing and does not count. On rounded shapes, where creases of that size
/// are no more frequent than sharper ones, polygons are not joined on these grounds. Less than
/// 0.001 degrees always are one plane. \pre each edge has at most two faces, which run along it in
/// opposite directions
DrawnPlanes find_drawn_planes(const TriangleSoup& soup);

}  // namespace foldwright
