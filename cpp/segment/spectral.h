#pragma once

#include <cstdint>
#include <span>

#include "segment/affinity.h"
#include "segment/labels.h"

namespace foldwright {

/// No paper model is crafted from more parts than that unless someone asks for them.
inline constexpr int kMostEstimatedParts = 20;

struct SpectralOptions {
  int parts = 1;      ///< number of clusters, 1 to the number of panels
  int restarts = 10;  ///< of k-means++; the best inertia wins, then the lowest restart
  std::uint64_t seed = 1;
  /// Per panel the one where its mirror image is: then restarts whose clusters mirror each other
  /// are preferred, and clusters that nearly do are made to (`mirror_clusters`). Or empty.
  std::span<const int> images = {};
};

/// Normalised spectral clustering [paper, 4.2]: k-means++ on the row-normalised leading
/// eigenvectors of D^-1/2 A D^-1/2.
///
/// Does not look at adjacency: see `connect_parts`. Deterministic for a seed; eigenvectors get a
/// fixed sign. Cost: a dense matrix of size^2, and per
/// eigenvector some products with it.
Labels spectral_clusters(const Affinity& affinity, const SpectralOptions& options = {});

/// The number of clusters k, 1 to 20, with the largest drop from the k-th eigenvalue of
/// D^-1/2 A D^-1/2 to the next, on average over some affinities of the same panels, times k^0.2.
///
/// Several affinities, because one spectrum often has two drops that are nearly equal. The factor,
/// because a part too many harms less than one too few. \pre there is an affinity
int estimate_parts(std::span<const Affinity> affinities);

}  // namespace foldwright
