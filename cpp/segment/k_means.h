#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace foldwright {

struct KMeansOptions {
  int restarts = 10;
  int iterations = 100;  ///< per restart; Lloyd's algorithm settles within some tens
  std::uint64_t seed = 1;
  /// What the inertia of a restart's labels counts times when restarts are compared; none: once.
  std::function<double(std::span<const int>)> factor = {};
};

/// Clusters the rows of `points` into k groups by Lloyd's algorithm from k-means++ seeds; the
/// restart of least inertia wins, the first among equals. Every label in [0, k) is used as long as
/// there are k different points. \pre 1 <= k <= rows
std::vector<int> k_means(const Eigen::MatrixXd& points, int k, const KMeansOptions& options = {});

}  // namespace foldwright
