#pragma once

#include "segment/labels.h"

namespace foldwright {

struct BorderCost {
  /// How far a border may move, in model units; moving it costs the more the farther it goes.
  double reach = 0;
  /// What a border that follows a crease saves: along a mean fold it costs 1 / (1 + crease) of its
  /// length, along a flat one all of it.
  double crease = 1;
  double convex = 0.5;  ///< share of that for mountains: people draw borders along valleys
};

/// Makes the borders between parts short, and lets them follow creases.
///
/// For each pair of neighbouring parts, the least of
///   sum over border hinges of length / (1 + crease * bend)
///   + sum over panels that change sides of area * distance / reach^2,
/// where bend = (1 - cos angle) over its mean, for mountains times `convex`, and distance is that
/// to the pair's border over centroids and midpoints of hinges. Panels farther away than `reach`
/// stay. A least cut finds it exactly. Parts stay connected, and none is lost; a pair for which
/// that cannot be had keeps its border. \pre parts are connected
Labels smooth_borders(const Mesh& mesh, const DualGraph& graph, Labels labels,
                      const BorderCost& cost);

}  // namespace foldwright
