#pragma once

#include "unfold/net.h"

namespace foldwright::testing {

/// A net of a whole mesh without overlaps, `size` mm large where the mesh has an extent of 2.
Net net_of(const Mesh& mesh, double size);

}  // namespace foldwright::testing
