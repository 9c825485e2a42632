#pragma once

#include <optional>
#include <vector>

#include "segment/labels.h"

namespace foldwright {

/// Parts with other borders, as many as before.
struct Regrouping {
  Labels labels;
  std::vector<int> changed;  ///< parts that are not what they were, ascending
};

struct RegroupOptions {
  int part;            ///< the one that is dissolved
  int learned_panels;  ///< of the graph that labels were learned on
};

/// Dissolves a part that is far from having a net: it joins a neighbour that balances its
/// curvature, and the largest other part is split in its stead.
///
/// A smooth saddle has no net however it is shared out, because every cut that ends inside makes
/// the faces around it overlap; together with what bulges next to it, cuts find ends there. So the
/// neighbour is the one with the longest border to it among those with which, over the inner
/// vertices of both, there is much less negative curvature for the positive one. What is split is
/// halved, with a border as smooth as learning on `learned_panels` panels leaves it (see
/// `smooth_labels`). None if no neighbour will do, or no other part can be split.
/// \pre parts are connected
std::optional<Regrouping> regroup(const Mesh& mesh, const DualGraph& graph, const Labels& labels,
                                  const RegroupOptions& options);

/// Regroups the parts of which curvature alone tells that they are saddles without a net, so that
/// no search has to find out: compact parts of some panels with much more negative than positive
/// curvature. Each part is regrouped once at most, the most curved first; what no neighbour betters
/// stays.
/// \pre parts are connected
Labels regroup_saddles(const Mesh& mesh, const DualGraph& graph, int learned_panels, Labels labels);

}  // namespace foldwright
