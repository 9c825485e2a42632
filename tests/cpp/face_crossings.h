#pragma once

#include "mesh/mesh.h"

namespace foldwright::testing {

/// Pairs of faces without a common vertex that run through each other by more than a touch.
int crossing_count(const Mesh& mesh);

/// Two meshes as one, the second one shifted.
Mesh both(const Mesh& first, const Mesh& second, const Vec3& shift);

}  // namespace foldwright::testing
