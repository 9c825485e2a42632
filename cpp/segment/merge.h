#pragma once

#include "segment/foldability.h"
#include "segment/labels.h"

namespace foldwright {

struct MergeOptions {
  int parts = 0;  ///< 1 to the number of panels; 0: until merging costs more than `stop`
  int power = 5;  ///< elementwise power of M, measured best together with the geodesic
  /// Falloff of the affinity exp(-G / falloff) with the concave geodesic G, in mean distances.
  double falloff = 0.4;
  /// Estimating the number: a softer affinity, M^4, and the cost above which parts stay apart.
  int estimate_power = 4;
  double stop = 0.75;
  int most_estimated = 30;  ///< parts that an estimate yields at the most
};

/// Merges panels into parts by least increase of the normalised cut [after paper, 4.2].
///
/// Starts from one region per panel and merges the adjacent pair X, Y with the least
/// S_XX/vol_X + S_YY/vol_Y - (S_XX + S_YY + 2 S_XY)/(vol_X + vol_Y), where S sums the affinity
/// A = M^power exp(-G/falloff) between regions. Parts are connected by construction, and no random
/// seed is involved. `matrix`: one row per panel of the graph. The result has at least one part per
/// connected component. Cost: two dense matrices, quadratic time, and `concave_geodesic`.
Labels merge_clusters(const Mesh& mesh, const DualGraph& graph, const FoldabilityMatrix& matrix,
                      const MergeOptions& options = {});

}  // namespace foldwright
