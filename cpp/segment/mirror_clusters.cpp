#include "segment/mirror_clusters.h"

#include <algorithm>
#include <limits>

namespace foldwright {
namespace {

constexpr int kRounds = 10;

int cluster_count(std::span<const int> labels) {
  return 1 + *std::max_element(labels.begin(), labels.end());
}

/// How many points of one cluster have their images in another, on average over both directions.
Eigen::MatrixXd image_counts(std::span<const int> labels, std::span<const int> images) {
  const int clusters = cluster_count(labels);
  Eigen::MatrixXd counts = Eigen::MatrixXd::Zero(clusters, clusters);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    counts(labels[i], labels[images[i]]) += 0.5;
    counts(labels[images[i]], labels[i]) += 0.5;
  }
  return counts;
}

/// The partner of every cluster; -1 where most images of either lie elsewhere.
std::vector<int> partners_of(const Eigen::MatrixXd& counts) {
  const Eigen::VectorXd sizes = counts.rowwise().sum();
  std::vector<int> partners(counts.rows(), -1);
  for (int a = 0; a < counts.rows(); ++a) {
    for (int b = 0; b < counts.cols(); ++b) {
      // More than half of both: nobody can have two.
      if (counts(a, b) > 0.5 * std::max(sizes[a], sizes[b])) partners[a] = b;
    }
  }
  return partners;
}

Eigen::MatrixXd centres_of(const Eigen::MatrixXd& points, std::span<const int> labels,
                           int clusters) {
  Eigen::MatrixXd centres = Eigen::MatrixXd::Zero(clusters, points.cols());
  std::vector<int> sizes(clusters, 0);
  for (int i = 0; i < points.rows(); ++i) {
    centres.row(labels[i]) += points.row(i);
    ++sizes[labels[i]];
  }
  for (int c = 0; c < clusters; ++c) centres.row(c) /= std::max(sizes[c], 1);
  return centres;
}

/// Assigns points and their images together, among clusters with a partner.
std::vector<int> assigned(const Eigen::MatrixXd& points, std::span<const int> images,
                          std::span<const int> labels, const std::vector<int>& partners) {
  const auto clusters = static_cast<int>(partners.size());
  const Eigen::MatrixXd centres = centres_of(points, labels, clusters);
  std::vector<int> next(labels.begin(), labels.end());
  for (int i = 0; i < points.rows(); ++i) {
    const int image = images[i];
    if (partners[labels[i]] == -1 || partners[labels[image]] == -1) continue;
    double least = std::numeric_limits<double>::infinity();
    for (int c = 0; c < clusters; ++c) {
      if (partners[c] == -1) continue;
      const double cost = (points.row(i) - centres.row(c)).squaredNorm() +
                          (points.row(image) - centres.row(partners[c])).squaredNorm();
      if (cost < least) least = cost, next[i] = c;
    }
  }
  return next;
}

bool uses_all(std::span<const int> labels, int clusters) {
  std::vector<char> used(clusters, 0);
  for (const int label : labels) used[label] = 1;
  return std::ranges::all_of(used, [](char is_used) { return is_used != 0; });
}

}  // namespace

double mirrored_share(std::span<const int> labels, std::span<const int> images) {
  return image_counts(labels, images).rowwise().maxCoeff().sum() /
         static_cast<double>(labels.size());
}

std::vector<int> mirror_clusters(const Eigen::MatrixXd& points, std::span<const int> images,
                                 std::vector<int> labels) {
  const int clusters = cluster_count(labels);
  for (int round = 0; round < kRounds; ++round) {
    const std::vector<int> partners = partners_of(image_counts(labels, images));
    std::vector<int> next = assigned(points, images, labels, partners);
    if (next == labels || !uses_all(next, clusters)) break;
    labels = std::move(next);
  }
  return labels;
}

}  // namespace foldwright
