#pragma once

#include "segment/foldability.h"
#include "segment/labels.h"

namespace foldwright {

struct SubdivideOptions {
  int parts;  ///< 1 to the number of panels
  std::uint64_t seed = 1;
};

/// Splits a part into so many connected ones, by foldability among its own panels and by shape.
///
/// Differs from `segment` in how much the two count: a part has a net, or nearly, so that its
/// foldability tells little but which few panels are awkward, and sharp affinities would cut off
/// just those. `matrix`: one row per panel. \pre graph is connected
Labels subdivide(const Mesh& mesh, const DualGraph& graph, const FoldabilityMatrix& matrix,
                 const SubdivideOptions& options);

}  // namespace foldwright
