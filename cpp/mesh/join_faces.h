#pragma once

#include "mesh/edge_groups.h"
#include "mesh/orient.h"
#include "mesh/triangle_soup.h"

namespace foldwright {

/// Joins the two faces of every edge that has just two; all other half-edges get no partner.
Partners join_manifold_edges(const TriangleSoup& soup, const EdgeGroups& groups);

/// Joins faces at edges that have more than two, in pairs that bound the solid between them, so
/// that two cubes that share an edge come apart as two closed cubes. What cannot be paired becomes
/// a border. Returns the number of such edges.
///
/// Pairs within a patch that encloses a volume go first: a fin on a closed body does not open it.
/// Coincident faces count as the two sides of a wall, not as the inside of nothing: sheets with two
/// sides stay in one piece.
/// \pre the faces are turned as `orientation` says, and the groups are those of the turned faces
int join_nonmanifold_edges(const TriangleSoup& soup, const EdgeGroups& groups,
                           const Orientation& orientation, Partners& partners);

}  // namespace foldwright
