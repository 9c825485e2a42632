#pragma once

#include "segment/labels.h"

namespace foldwright {

/// Total by which the parts' insides fall short of what a net needs in positive curvature, in
/// radians; 0 when no part holds a pocket.
///
/// Where a part is cut open, every cut inside it is a tree that hangs from the border, and a tree
/// that ends at a vertex of more than a full turn makes the faces around it overlap: each needs
/// ends at vertices of less. A pocket is a connected set of inner vertices of a part, none of whose
/// edges leads to other inner ones, with too little positive curvature for its negative one.
double pocket_deficit(const Mesh& mesh, const DualGraph& graph, const Labels& labels);

/// Opens pockets: hands border panels next to them to the neighbouring part, or takes some, one by
/// one, as long as that lessens the deficit. Parts stay connected, and none is lost.
/// \pre parts are connected
Labels open_pockets(const Mesh& mesh, const DualGraph& graph, Labels labels);

}  // namespace foldwright
