#pragma once

#include <cstdint>

#include "segment/foldability.h"
#include "segment/labels.h"

namespace foldwright {

struct SpectralOptions {
  int parts = 0;  ///< number of clusters, 1 to the number of panels; 0: by the largest eigengap
  /// Elementwise power of M that serves as affinity. M saturates near 1, so that raw M makes parts
  /// of nearly equal size; the eighth power measured best on the Princeton benchmark.
  int power = 8;
  int restarts = 10;  ///< of k-means++; the best inertia wins, then the lowest restart
  std::uint64_t seed = 1;
};

/// Normalised spectral clustering of the foldability matrix [paper, 4.2]: k-means++ on the
/// row-normalised leading eigenvectors of D^-1/2 M^p D^-1/2.
///
/// Does not look at adjacency: see `connect_parts`. Deterministic for a seed; eigenvectors get a
/// fixed sign. Estimated numbers lie in 1 to 20. Cost: a dense matrix of size^2, and per
/// eigenvector some products with it.
Labels spectral_clusters(const FoldabilityMatrix& matrix, const SpectralOptions& options = {});

}  // namespace foldwright
