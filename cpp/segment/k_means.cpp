#include "segment/k_means.h"

#include <cassert>
#include <limits>

#include "geometry/random.h"

namespace foldwright {
namespace {

struct Clustering {
  std::vector<int> labels;
  Eigen::VectorXd distances;  ///< squared, of each point to its centre
  double inertia() const { return distances.sum(); }
};

/// Squared distances of all points to one centre.
Eigen::VectorXd distances_to(const Eigen::MatrixXd& points, const Eigen::RowVectorXd& centre) {
  return (points.rowwise() - centre).rowwise().squaredNorm();
}

/// k-means++: each further centre is a point drawn with probability proportional to its squared
/// distance from the centres so far.
Eigen::MatrixXd seed_centres(const Eigen::MatrixXd& points, int k, Random& random) {
  const int n = static_cast<int>(points.rows());
  Eigen::MatrixXd centres(k, points.cols());
  centres.row(0) = points.row(random.below(n));
  Eigen::VectorXd nearest = distances_to(points, centres.row(0));
  for (int c = 1; c < k; ++c) {
    double left = random.uniform() * nearest.sum();
    int chosen = 0;
    while (chosen + 1 < n && (left -= nearest[chosen]) > 0) ++chosen;
    centres.row(c) = points.row(chosen);
    nearest = nearest.cwiseMin(distances_to(points, centres.row(c)));
  }
  return centres;
}

Clustering assign(const Eigen::MatrixXd& points, const Eigen::MatrixXd& centres) {
  const int n = static_cast<int>(points.rows());
  Clustering result{std::vector<int>(n, 0), distances_to(points, centres.row(0))};
  for (int c = 1; c < centres.rows(); ++c) {
    const Eigen::VectorXd distances = distances_to(points, centres.row(c));
    for (int i = 0; i < n; ++i) {
      if (distances[i] >= result.distances[i]) continue;
      result.distances[i] = distances[i];
      result.labels[i] = c;
    }
  }
  return result;
}

/// Means of the clusters; an empty one moves to the point that is worst served.
Eigen::MatrixXd update_centres(const Eigen::MatrixXd& points, int k, Clustering& clustering) {
  Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(k, points.cols());
  std::vector<int> sizes(k, 0);
  for (int i = 0; i < points.rows(); ++i) {
    sums.row(clustering.labels[i]) += points.row(i);
    ++sizes[clustering.labels[i]];
  }
  for (int c = 0; c < k; ++c) {
    if (sizes[c] > 0) {
      sums.row(c) /= sizes[c];
      continue;
    }
    Eigen::Index farthest = 0;
    clustering.distances.maxCoeff(&farthest);
    sums.row(c) = points.row(farthest);
    clustering.distances[farthest] = 0;
  }
  return sums;
}

Clustering lloyd(const Eigen::MatrixXd& points, int k, int iterations, Random& random) {
  Eigen::MatrixXd centres = seed_centres(points, k, random);
  Clustering clustering = assign(points, centres);
  for (int i = 0; i < iterations; ++i) {
    centres = update_centres(points, k, clustering);
    Clustering next = assign(points, centres);
    const bool settled = next.labels == clustering.labels;
    clustering = std::move(next);
    if (settled) break;
  }
  return clustering;
}

}  // namespace

std::vector<int> k_means(const Eigen::MatrixXd& points, int k, const KMeansOptions& options) {
  assert(1 <= k && k <= points.rows());
  Clustering best;
  double least = std::numeric_limits<double>::infinity();
  for (int restart = 0; restart < options.restarts; ++restart) {
    Random random(
        task_seed(options.seed, SeedTag::kClustering, 0, static_cast<std::uint64_t>(restart)));
    Clustering clustering = lloyd(points, k, options.iterations, random);
    const double factor = options.factor ? options.factor(clustering.labels) : 1;
    const double cost = clustering.inertia() * factor;
    if (cost >= least) continue;
    least = cost;
    best = std::move(clustering);
  }
  return best.labels;
}

}  // namespace foldwright
