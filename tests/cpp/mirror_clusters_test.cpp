#include "segment/mirror_clusters.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace foldwright::testing {
namespace {

/// Points of a line, each with its image on the other side of zero.
struct Line {
  Eigen::MatrixXd points;
  std::vector<int> images;
};

Line line(const std::vector<double>& right) {
  const auto half = static_cast<int>(right.size());
  Line line{Eigen::MatrixXd(2 * half, 1), std::vector<int>(2 * half)};
  for (int i = 0; i < half; ++i) {
    line.points(i, 0) = -right[i];
    line.points(half + i, 0) = right[i];
    line.images[i] = half + i;
    line.images[half + i] = i;
  }
  return line;
}

TEST(MirroredShare, IsOneForHalvesAndBandsAndLessForWhatLiesAskew) {
  const std::vector<int> images = {5, 4, 3, 2, 1, 0};
  EXPECT_EQ(mirrored_share(std::vector{0, 0, 0, 1, 1, 1}, images), 1);
  EXPECT_EQ(mirrored_share(std::vector{0, 1, 2, 2, 1, 0}, images), 1);
  EXPECT_LT(mirrored_share(std::vector{0, 0, 1, 1, 1, 1}, images), 1);
}

TEST(MirrorClusters, PutRightWhatOneSideHasDifferently) {
  // On the left the fourth point went to the middle, on the right to the end.
  const Line both = line({1, 2, 3, 4.1, 6, 7, 8});
  const std::vector<int> labels = {1, 1, 1, 1, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2};
  const std::vector<int> mirrored = mirror_clusters(both.points, both.images, labels);
  for (int i = 0; i < 7; ++i) {
    EXPECT_EQ(mirrored[i], 2 - mirrored[7 + i]) << i << ": the ends are each other's images";
  }
  EXPECT_EQ(mirrored[0], 1);
  EXPECT_EQ(mirrored[6], 0);
}

TEST(MirrorClusters, LeaveAloneWhatMirrorsItselfAlready) {
  const Line both = line({1, 2, 6, 7});
  const std::vector<int> labels = {1, 1, 0, 0, 1, 1, 2, 2};
  EXPECT_EQ(mirror_clusters(both.points, both.images, labels), labels);
}

TEST(MirrorClusters, LeaveAloneWhatHasNoPartner) {
  // The left half is one cluster, the right one falls into three.
  const Line both = line({1, 2, 6, 7, 11, 12});
  const std::vector<int> labels = {0, 0, 0, 0, 0, 0, 1, 1, 2, 2, 3, 3};
  EXPECT_EQ(mirror_clusters(both.points, both.images, labels), labels);
}

TEST(MirrorClusters, NeverLoseAClusterToAnother) {
  // Labels that have little to do with where the points are.
  const Line both = line({1, 2, 3, 4, 5, 6});
  for (int k = 1; k <= 6; ++k) {
    std::vector<int> labels;
    for (int i = 0; i < 12; ++i) labels.push_back(i * 7 % k);
    std::vector<int> mirrored = mirror_clusters(both.points, both.images, labels);
    std::ranges::sort(mirrored);
    mirrored.erase(std::unique(mirrored.begin(), mirrored.end()), mirrored.end());
    EXPECT_EQ(static_cast<int>(mirrored.size()), k);
  }
}

}  // namespace
}  // namespace foldwright::testing
