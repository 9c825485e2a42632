#include "segment/affinity.h"

#include <cassert>
#include <cmath>

#include "segment/concave_geodesic.h"

namespace foldwright {
namespace {

double power_of(double base, int exponent) {
  double result = 1;
  for (int i = 0; i < exponent; ++i) result *= base;
  return result;
}

}  // namespace

Affinity foldability_affinity(const FoldabilityMatrix& matrix, int power) {
  Affinity affinity(matrix.size, matrix.size);
  for (int i = 0; i < matrix.size; ++i) {
    for (int j = 0; j < matrix.size; ++j) affinity(i, j) = power_of(matrix(i, j), power);
  }
  return affinity;
}

Affinity shape_affinity(const Mesh& mesh, const DualGraph& graph, const FoldabilityMatrix& matrix,
                        const ShapeCue& cue) {
  assert(matrix.size == graph.panel_count());
  Affinity affinity = foldability_affinity(matrix, cue.power);
  const std::vector<float> geodesic = concave_geodesic(mesh, graph);
  for (int i = 0; i < matrix.size; ++i) {
    for (int j = 0; j < matrix.size; ++j) {
      const float distance = geodesic[static_cast<std::size_t>(i) * matrix.size + j];
      affinity(i, j) *= std::exp(-distance / cue.falloff);
    }
  }
  return affinity;
}

}  // namespace foldwright
