#pragma once

#include <optional>
#include <vector>

#include "mesh/dual_graph.h"

namespace foldwright {

/// How the panels and hinges of one graph lie on those of another one, after a rotation and a
/// shift, or a reflection besides.
struct Congruence {
  std::vector<int> panels;  ///< per panel of the first graph: the one of the second
  std::vector<int> hinges;  ///< likewise
  bool is_mirrored = false;
  double error = 0;  ///< how far the two are from each other, in mean edge lengths
};

/// Whether the surfaces of two graphs are the same but for where they lie, to a thousandth of the
/// mean edge length: by their hinges with what these join, and the panels' areas and centroids.
///
/// Hinges that stay folds lie on such. Of several ways one without a reflection comes first. None
/// for graphs without hinges. What is true of unfoldings of the first graph is true of the second
/// one's up to `error`; whether faces overlap, which touch in the first one, is to be looked at
/// again. Time: some candidates, mostly one, each near-linear.
std::optional<Congruence> find_congruence(const Mesh& mesh, const DualGraph& first,
                                          const DualGraph& second);

}  // namespace foldwright
