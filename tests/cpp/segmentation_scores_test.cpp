#include "segmentation_scores.h"

#include <gtest/gtest.h>

#include "meshes.h"

namespace foldwright::testing {
namespace {

TEST(RandIndexError, CountsPairsThatOneSegmentationKeepsTogether) {
  const std::vector<int> one = {0, 0, 0, 0};
  const std::vector<int> halves = {5, 5, 2, 2};
  const std::vector<int> crossing = {0, 1, 0, 1};
  EXPECT_EQ(rand_index_error(halves, halves), 0);
  EXPECT_EQ(rand_index_error(halves, std::vector<int>{1, 1, 0, 0}), 0);
  EXPECT_DOUBLE_EQ(rand_index_error(one, halves), 4.0 / 6);
  EXPECT_DOUBLE_EQ(rand_index_error(halves, crossing), 4.0 / 6);
}

TEST(CutDiscrepancy, IsZeroBetweenEqualCutsAndMissingWithoutACut) {
  const Mesh strip = open_strip(6);
  std::vector<int> labels(12, 0);
  EXPECT_FALSE(cut_discrepancy(strip, labels, labels).exists);
  labels[0] = 1;
  const CutDiscrepancy same = cut_discrepancy(strip, labels, labels);
  EXPECT_TRUE(same.exists);
  EXPECT_EQ(same.of_cuts, 0);
  EXPECT_EQ(same.of_vertices, 0);
}

TEST(CutDiscrepancy, MeasuresTheWayBetweenCuts) {
  // Squares 0 to 5 in a row: cuts across it after the second and after the fifth square, each at
  // two vertices, lie three units apart.
  const Mesh strip = open_strip(6);
  std::vector<int> early, late;
  for (int face = 0; face < 12; ++face) {
    early.push_back(face / 2 < 2);
    late.push_back(face / 2 < 5);
  }
  Vec3 centroid = Vec3::Zero();
  for (const Vec3& p : strip.positions) centroid += p / 14.0;
  double radius = 0;
  for (const Vec3& p : strip.positions) radius += (p - centroid).norm() / 14.0;
  const CutDiscrepancy far = cut_discrepancy(strip, early, late);
  EXPECT_TRUE(far.exists);
  EXPECT_NEAR(far.of_cuts, 6 / radius, 1e-12);
  EXPECT_NEAR(far.of_vertices, 4 * 3.0 / 14 / radius, 1e-12);
}

TEST(MirrorSymmetry, IsTheShareOfAreaThatComesToLieOnTheImageOfItsPart) {
  const std::vector<int> images = {3, 2, 1, 0};  // a row of four panels, mirrored at its middle
  const std::vector<double> areas = {1, 2, 2, 1};
  EXPECT_EQ(mirror_symmetry(std::vector{0, 0, 0, 0}, areas, images), 1);
  EXPECT_EQ(mirror_symmetry(std::vector{0, 0, 1, 1}, areas, images), 1);
  EXPECT_EQ(mirror_symmetry(std::vector{0, 1, 1, 0}, areas, images), 1);
  // The second part lies across the middle and keeps most of itself; the first is small.
  EXPECT_DOUBLE_EQ(mirror_symmetry(std::vector{0, 1, 1, 1}, areas, images), 5.0 / 6);
}

}  // namespace
}  // namespace foldwright::testing
