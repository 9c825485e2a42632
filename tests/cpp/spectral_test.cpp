#include "segment/spectral.h"

#include <gtest/gtest.h>

#include <numeric>

#include "geometry/random.h"

namespace foldwright::testing {
namespace {

/// Faces in blocks of the given sizes: within a block they unfold together nearly always, across
/// blocks in the share `across` of all runs.
Affinity blocks(const std::vector<int>& sizes, float across, std::uint64_t seed = 1) {
  Labels block;
  for (int b = 0; b < static_cast<int>(sizes.size()); ++b) block.insert(block.end(), sizes[b], b);
  const int n = static_cast<int>(block.size());
  Random random(seed);
  FoldabilityMatrix matrix{n, std::vector<float>(static_cast<std::size_t>(n) * n)};
  for (int i = 0; i < n; ++i) {
    matrix.values[i * n + i] = 1;
    for (int j = 0; j < i; ++j) {
      const auto noise = static_cast<float>(0.05 * random.uniform());
      const float value = block[i] == block[j] ? 0.95f + noise : across;
      matrix.values[i * n + j] = matrix.values[j * n + i] = value;
    }
  }
  return foldability_affinity(matrix);
}

Labels block_labels(const std::vector<int>& sizes) {
  Labels labels;
  for (int b = 0; b < static_cast<int>(sizes.size()); ++b) labels.insert(labels.end(), sizes[b], b);
  return labels;
}

TEST(SpectralClusters, TellWeaklyLinkedBlobsApart) {
  const std::vector<std::vector<int>> cases = {{10, 10}, {40, 60}, {30, 5, 50, 20}, {150, 90, 120}};
  for (const auto& sizes : cases) {
    const int parts = static_cast<int>(sizes.size());
    SCOPED_TRACE(parts);
    EXPECT_EQ(spectral_clusters(blocks(sizes, 0.5f), {.parts = parts}), block_labels(sizes));
  }
}

TEST(SpectralClusters, TellUnlinkedBlobsApart) {
  // Equal leading eigenvalues: any basis of their space has to do.
  for (const auto& sizes : std::vector<std::vector<int>>{{3, 4}, {20, 20, 20}, {50, 60, 70, 80}}) {
    const int parts = static_cast<int>(sizes.size());
    SCOPED_TRACE(parts);
    EXPECT_EQ(spectral_clusters(blocks(sizes, 0), {.parts = parts}), block_labels(sizes));
  }
}

TEST(SpectralClusters, EstimateTheNumber) {
  for (const auto& sizes : std::vector<std::vector<int>>{{20, 30}, {10, 20, 30}, {40, 40, 9, 25}}) {
    EXPECT_EQ(estimate_parts(blocks(sizes, 0.5f)), static_cast<int>(sizes.size()));
  }
}

TEST(SpectralClusters, CopeWithFacesThatAllUnfoldTogether) {
  for (const int size : {2, 23, 60, 300}) {
    SCOPED_TRACE(size);
    const Affinity ones = Affinity::Ones(size, size);
    EXPECT_LE(part_count(spectral_clusters(ones, {.parts = 2})), 2);
    EXPECT_EQ(estimate_parts(ones), 1);
  }
}

TEST(SpectralClusters, OfOneAndOfAll) {
  const Affinity matrix = blocks({6, 6}, 0.5f);
  EXPECT_EQ(spectral_clusters(matrix, {.parts = 1}), Labels(12, 0));
  Labels each(12);
  std::iota(each.begin(), each.end(), 0);
  EXPECT_EQ(spectral_clusters(matrix, {.parts = 12}), each);
  EXPECT_EQ(part_count(spectral_clusters(matrix, {.parts = 11})), 11);
  EXPECT_EQ(spectral_clusters(Affinity::Ones(1, 1)), Labels{0});
  EXPECT_EQ(estimate_parts(Affinity::Ones(1, 1)), 1);
}

TEST(SpectralClusters, DependOnTheSeedAlone) {
  const Affinity matrix = blocks({50, 50, 50}, 0.8f);
  EXPECT_EQ(spectral_clusters(matrix, {.parts = 9, .seed = 4}),
            spectral_clusters(matrix, {.parts = 9, .seed = 4}));
}

}  // namespace
}  // namespace foldwright::testing
