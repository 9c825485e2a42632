#pragma once

#include <limits>

#include "segment/foldability.h"
#include "segment/labels.h"

namespace foldwright {

/// What panels are clustered by. `kShape`: foldability and a concave geodesic. `kFoldability`: the
/// paper's own clustering, from foldability alone.
enum class Segmenter { kShape, kFoldability };

struct SegmentOptions {
  Segmenter segmenter = Segmenter::kShape;
  int parts = 0;             ///< number of parts, at most the number of panels; 0 estimates it
  bool whole_first = false;  ///< estimate one part, whatever the spectrum shows
  std::uint64_t seed = 1;
  /// With `kShape` and an estimated number: parts of more area, in square model units, are divided
  /// as `subdivide` does it, until there are 20 parts.
  double largest_area = std::numeric_limits<double>::infinity();
};

/// Connected parts of the graph that was learned on: spectral clusters, made connected by Eq. (1)
/// [paper, 4.2]. `matrix`: one row per panel.
/// \pre graph is connected
Labels segment(const Mesh& mesh, const DualGraph& graph, const FoldabilityMatrix& matrix,
               const SegmentOptions& options = {});

/// Carries labels of a learned graph to the graph that it stands for: each panel takes the label of
/// its row, stray panels follow Eq. (1), and parts that got lost on the way are made up for by
/// splitting the largest ones, until there are as many as among `labels`.
Labels carry_labels(const Mesh& mesh, const DualGraph& graph, const CarriedFoldability& foldability,
                    const Labels& labels);

/// What labels come from.
struct LearnedBy {
  Segmenter segmenter;
  int panels;  ///< of the graph that was learned on
};

/// Makes the borders of carried labels short, within what learning on so many panels leaves open:
/// see `smooth_borders`. With the shape as a cue they follow creases, too.
/// \pre parts are connected
Labels smooth_labels(const Mesh& mesh, const DualGraph& graph, Labels labels,
                     const LearnedBy& learned);

/// Halves a connected graph: what is nearer to one of two panels far apart than to the other. Both
/// halves are connected. \pre at least two panels
Labels halve(const Mesh& mesh, const DualGraph& graph);

/// Splits a connected graph into two connected parts by what was learned. \pre at least two panels
Labels split_in_two(const Mesh& mesh, const DualGraph& graph,
                    const CarriedFoldability& foldability);

}  // namespace foldwright
