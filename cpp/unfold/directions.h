#pragma once

#include <vector>

#include "geometry/random.h"
#include "mesh/dual_graph.h"

namespace foldwright {

/// Where the directions of the heuristics come from [paper, 4.1.1].
enum class DirectionSet { kRandom, kFaceNormals, kVertexNormals, kEdges };

/// Uniformly random unit vector.
Vec3 random_direction(Random& random);

/// `count` unit vectors. Surface sets are drawn from in random order without repetition as long as
/// they last, then anew; so `count` = size of the set gives the whole set.
std::vector<Vec3> make_directions(const Mesh& mesh, DirectionSet set, int count, Random& random);

}  // namespace foldwright
