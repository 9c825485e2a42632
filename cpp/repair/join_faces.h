#pragma once

#include "repair/edge_groups.h"
#include "repair/orient.h"
#include "repair/triangle_soup.h"

namespace foldwright {

/// Joins the two faces of every edge that has just two, and of an edge with more those two that
/// belong to one polygon of the file; all other half-edges get no partner.
Partners join_manifold_edges(const TriangleSoup& soup, const EdgeGroups& groups);

/// Joins the free faces at edges that have more than two, in pairs that bound the solid between
/// them, so that two cubes that share an edge come apart as two closed cubes. What cannot be paired
/// becomes a border. Returns the number of such edges; those inside polygons do not count.
///
/// Pairs within a patch that encloses a volume go first: a fin on a closed body does not open it.
/// Then those in one plane, unless faces coincide there: sheets that cross stay flat.
/// Coincident faces count as the two sides of a wall, not as the inside of nothing: sheets with two
/// sides stay in one piece.
/// \pre the faces are turned as `orientation` says, and the groups are those of the turned faces
int join_nonmanifold_edges(const TriangleSoup& soup, const EdgeGroups& groups,
                           const Orientation& orientation, Partners& partners);

}  // namespace foldwright
