#pragma once

#include <string>

#include "mesh/mesh.h"
#include "mesh/polygon_soup.h"
#include "repair/repair.h"

namespace foldwright::testing {

/// What breaks the promises of `Mesh`, computed from positions and faces alone: an edge with more
/// than two faces or two in the same direction, a vertex with several fans, an unused vertex, a
/// degenerate triangle, a closed component of negative volume, a centre that is not the origin.
/// Empty when nothing does.
std::string fault_of(const Mesh& mesh);

/// The same of a simplified mesh, which may be off-centre.
std::string fault_of_centred(Mesh mesh);

/// What breaks the promises of `repair` beyond those of its mesh: a source face that is neither in
/// `source_faces` nor counted as dropped, a repair reported twice. Empty when nothing does.
std::string bookkeeping_fault_of(const RepairedModel& model);

/// What breaks the promises about the places in the file that corners come from: one that is no
/// place in a polygon, or not in the face's own, or further from the corner than
/// `RepairedModel::largest_move`. Empty when nothing does.
std::string origin_fault_of(const PolygonSoup& soup, const RepairedModel& model);

/// The same after simplifying: the places of the corners of `simple` may be further from them by
/// the distance of the corners from the model's surface.
std::string origin_fault_of(const PolygonSoup& soup, const RepairedModel& model, const Mesh& simple,
                            const std::vector<FaceOrigins>& origins);

}  // namespace foldwright::testing
