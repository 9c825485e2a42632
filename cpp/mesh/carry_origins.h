#pragma once

#include <span>
#include <vector>

#include "mesh/corner_origin.h"
#include "mesh/mesh.h"

namespace foldwright {

/// The places in the file that the corners of a mesh come from which stands for another one: those
/// of the nearest points on the other's surface. `origins`: of the other one's corners.
///
/// Of several faces that a corner is equally near to, as it is where it is a vertex of both meshes,
/// that one counts on whose side the corner's own face lies: nearest to a point a little further
/// in, and facing the same way. So corners keep to their side of an edge where texture coordinates
/// end, and of a thin sheet. About |to| log |from|. \pre `from` has a face
std::vector<FaceOrigins> carry_origins(const Mesh& from, std::span<const FaceOrigins> origins,
                                       const Mesh& to);

/// The largest distance of a vertex of either mesh from the surface of the other one, in model
/// units: how far simplifying has moved the surface, but for what rises between the vertices of
/// both. n log n. \pre both have a face
double largest_deviation(const Mesh& a, const Mesh& b);

}  // namespace foldwright
