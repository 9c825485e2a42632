#include "segment/subdivide.h"

#include <numeric>

#include "segment/affinity.h"
#include "segment/concave_geodesic.h"
#include "segment/connect_parts.h"
#include "segment/spectral.h"

namespace foldwright {
namespace {

// Of parts of spot and cat in five, the smaller half has a third to a half of the area this way,
// and most of its border is concave; with the cue for whole models it has two faces of ninety.
constexpr ShapeCue kCueWithinParts = {.power = 1, .falloff = 1};

}  // namespace

Labels subdivide(const Mesh& mesh, const DualGraph& graph, const FoldabilityMatrix& matrix,
                 const SubdivideOptions& options) {
  const Affinity affinity = shape_affinity(matrix, concave_geodesic(mesh, graph), kCueWithinParts);
  const Labels labels = spectral_clusters(affinity, {.parts = options.parts, .seed = options.seed});
  std::vector<int> rows(graph.panel_count());
  std::iota(rows.begin(), rows.end(), 0);
  return connect_parts(graph, {matrix, rows}, labels);
}

}  // namespace foldwright
