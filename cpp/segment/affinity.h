#pragma once

#include <Eigen/Core>

#include "segment/foldability.h"

namespace foldwright {

/// How much any two panels belong together: symmetric, entries in [0, 1], ones on the diagonal.
using Affinity = Eigen::MatrixXd;

/// M^power, elementwise. M saturates near 1, so that raw M makes parts of nearly equal size; powers
/// of 8 to 12 measured best on the Princeton benchmark.
Affinity foldability_affinity(const FoldabilityMatrix& matrix, int power = 8);

/// How sharply foldability and shape tell panels apart.
struct ShapeCue {
  int power = 5;  ///< of M
  /// Falloff of exp(-G / falloff) with the concave geodesic G, in mean distances.
  double falloff = 0.45;
};

/// M^power exp(-G / falloff): foldability, weakened across concave creases. The defaults are at the
/// middle of a plateau: powers of 4 to 6 and falloffs of 0.4 to 0.65 differ by less than 0.1 % of
/// Rand Index. `matrix`: one row per panel of the graph. Cost: see `concave_geodesic`.
Affinity shape_affinity(const Mesh& mesh, const DualGraph& graph, const FoldabilityMatrix& matrix,
                        const ShapeCue& cue = {});

}  // namespace foldwright
