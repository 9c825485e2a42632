#pragma once

#include <map>
#include <vector>

#include "repair/triangle_soup.h"

namespace foldwright {

/// Per half-edge the vertices to be inserted on it, in its direction.
using EdgeInsertions = std::map<int, std::vector<int>>;

/// Puts vertices on edges and cuts the faces into triangles accordingly. No new triangle has all
/// its corners on one old edge. New faces follow at the end, in the order of the old ones.
void insert_on_edges(TriangleSoup& soup, const EdgeInsertions& insertions);

}  // namespace foldwright
