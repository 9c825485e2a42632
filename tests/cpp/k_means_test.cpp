#include "segment/k_means.h"

#include <gtest/gtest.h>

#include <set>

#include "geometry/random.h"
#include "segment/labels.h"

namespace foldwright::testing {
namespace {

/// `size` points around each of the corners of a triangle with sides of about 10.
Eigen::MatrixXd three_blobs(Random& random, int size) {
  const Eigen::RowVector2d centres[] = {{0, 0}, {10, 0}, {5, 9}};
  Eigen::MatrixXd points(3 * size, 2);
  for (int i = 0; i < points.rows(); ++i) {
    points.row(i) = centres[i % 3] + Eigen::RowVector2d(random.uniform(), random.uniform());
  }
  return points;
}

double inertia(const Eigen::MatrixXd& points, const std::vector<int>& labels, int k) {
  double sum = 0;
  for (int c = 0; c < k; ++c) {
    Eigen::RowVectorXd mean = Eigen::RowVectorXd::Zero(points.cols());
    int size = 0;
    for (int i = 0; i < points.rows(); ++i) {
      if (labels[i] == c) mean += points.row(i), ++size;
    }
    mean /= size;
    for (int i = 0; i < points.rows(); ++i) {
      if (labels[i] == c) sum += (points.row(i) - mean).squaredNorm();
    }
  }
  return sum;
}

TEST(KMeans, TellsBlobsApart) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Labels labels = renumbered(k_means(three_blobs(random, 20), 3, {.seed = seed}));
    for (int i = 0; i < 60; ++i) EXPECT_EQ(labels[i], i % 3);
  }
}

TEST(KMeans, UsesEveryLabel) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Eigen::MatrixXd points = three_blobs(random, 5);
    for (const int k : {1, 2, 7, 15}) {
      const std::vector<int> labels = k_means(points, k, {.seed = seed});
      EXPECT_EQ(static_cast<int>(std::set(labels.begin(), labels.end()).size()), k);
    }
  }
}

TEST(KMeans, CopesWithCopiesOfOnePoint) {
  const std::vector<int> labels = k_means(Eigen::MatrixXd::Ones(5, 3), 2);
  EXPECT_EQ(labels.size(), 5u);
}

TEST(KMeans, MoreRestartsAreNeverWorse) {
  Random random(1);
  Eigen::MatrixXd points(80, 3);
  for (int i = 0; i < points.size(); ++i) points(i / 3, i % 3) = random.uniform();
  double before = std::numeric_limits<double>::infinity();
  for (const int restarts : {1, 2, 5, 20}) {
    const double now = inertia(points, k_means(points, 6, {.restarts = restarts}), 6);
    EXPECT_LE(now, before + 1e-12);
    before = now;
  }
}

TEST(KMeans, DependsOnTheSeedAlone) {
  Random random(2);
  const Eigen::MatrixXd points = three_blobs(random, 30);
  EXPECT_EQ(k_means(points, 8, {.restarts = 1, .seed = 1}),
            k_means(points, 8, {.restarts = 1, .seed = 1}));
  EXPECT_NE(k_means(points, 8, {.restarts = 1, .seed = 1}),
            k_means(points, 8, {.restarts = 1, .seed = 2}));
}

}  // namespace
}  // namespace foldwright::testing
