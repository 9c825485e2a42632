#include "segment/spectral.h"

#include <Spectra/MatOp/DenseSymMatProd.h>
#include <Spectra/SymEigsSolver.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <stdexcept>

#include "segment/k_means.h"
#include "segment/mirror_clusters.h"

namespace foldwright {
namespace {

// Products of different unit eigenvectors stay below this; Lanczos' own tolerance is 1e-10.
constexpr double kOrthogonal = 1e-6;

// Exponent of the factor in the estimate.
constexpr double kPreferMore = 0.2;

// Inertia counts so many times more for the share of panels that are not mirrored: restarts that
// differ by a tenth are often equally good, and not equally symmetric.
constexpr double kPreferMirrored = 1;

/// D^-1/2 A D^-1/2.
Eigen::MatrixXd normalized(const Affinity& affinity) {
  // The diagonal is one, so no row sum is zero.
  const Eigen::VectorXd scale = affinity.rowwise().sum().cwiseSqrt().cwiseInverse();
  return scale.asDiagonal() * affinity * scale.asDiagonal();
}

struct Eigenpairs {
  Eigen::VectorXd values;   ///< descending
  Eigen::MatrixXd vectors;  ///< columns
};

Eigenpairs all_eigenpairs(const Eigen::MatrixXd& matrix) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(matrix);
  return {solver.eigenvalues().reverse(), solver.eigenvectors().rowwise().reverse()};
}

/// The `count` largest eigenpairs by Lanczos' method; none when it does not converge.
Eigenpairs lanczos_eigenpairs(const Eigen::MatrixXd& matrix, int count, int basis) {
  Spectra::DenseSymMatProd<double> product(matrix);
  Spectra::SymEigsSolver<Spectra::DenseSymMatProd<double>> solver(product, count, basis);
  try {
    solver.init();
    solver.compute(Spectra::SortRule::LargestAlge);
  } catch (const std::runtime_error&) {
    // Breaks down when the matrix has fewer different eigenvalues than basis vectors, as that of a
    // convex part has: all ones.
    return {};
  }
  if (solver.info() != Spectra::CompInfo::Successful) return {};
  // Close to a breakdown rounding makes copies of a pair instead: their vectors are not orthogonal.
  const Eigen::MatrixXd vectors = solver.eigenvectors();
  const Eigen::MatrixXd products = vectors.transpose() * vectors;
  const auto identity = Eigen::MatrixXd::Identity(products.rows(), products.cols());
  if (!((products - identity).cwiseAbs().maxCoeff() < kOrthogonal)) return {};
  return {solver.eigenvalues(), vectors};
}

/// The `count` largest eigenvalues and their vectors, each with its largest entry positive.
Eigenpairs leading_eigenpairs(const Eigen::MatrixXd& matrix, int count) {
  Eigenpairs pairs;
  // Lanczos pays while few of many are wanted; 2 k + 20 basis vectors converge in a few restarts.
  const int basis = 2 * count + 20;
  if (basis < matrix.rows()) pairs = lanczos_eigenpairs(matrix, count, basis);
  if (pairs.values.size() == 0) pairs = all_eigenpairs(matrix);
  pairs.values = pairs.values.head(count).eval();
  pairs.vectors = pairs.vectors.leftCols(count).eval();
  for (int c = 0; c < count; ++c) {
    Eigen::Index largest = 0;
    pairs.vectors.col(c).cwiseAbs().maxCoeff(&largest);
    if (pairs.vectors(largest, c) < 0) pairs.vectors.col(c) *= -1;
  }
  return pairs;
}

}  // namespace

Labels spectral_clusters(const Affinity& affinity, const SpectralOptions& options) {
  const int n = static_cast<int>(affinity.rows());
  assert(0 < options.parts && options.parts <= n);
  if (options.parts == 1 || n == 1) return Labels(n, 0);
  if (options.parts == n) {
    Labels each(n);
    for (int i = 0; i < n; ++i) each[i] = i;
    return each;
  }
  Eigen::MatrixXd embedding = leading_eigenpairs(normalized(affinity), options.parts).vectors;
  for (int i = 0; i < n; ++i) {
    const double norm = embedding.row(i).norm();
    if (norm > 0) embedding.row(i) /= norm;
  }
  KMeansOptions k_means_options{.restarts = options.restarts, .seed = options.seed};
  if (options.images.empty()) return renumbered(k_means(embedding, options.parts, k_means_options));
  k_means_options.factor = [&](std::span<const int> labels) {
    return 1 + kPreferMirrored * (1 - mirrored_share(labels, options.images));
  };
  const Labels labels = k_means(embedding, options.parts, k_means_options);
  return renumbered(mirror_clusters(embedding, options.images, labels));
}

int estimate_parts(std::span<const Affinity> affinities) {
  const int n = static_cast<int>(affinities.front().rows());
  const int most = std::min(kMostEstimatedParts, n - 1);
  if (most < 1) return 1;
  Eigen::VectorXd values = Eigen::VectorXd::Zero(most + 1);
  for (const Affinity& affinity : affinities) {
    values += leading_eigenpairs(normalized(affinity), most + 1).values;
  }
  int best = 1;
  double largest = 0;
  for (int k = 1; k <= most; ++k) {
    const double drop = (values[k - 1] - values[k]) * std::pow(k, kPreferMore);
    if (drop > largest) best = k, largest = drop;
  }
  return best;
}

}  // namespace foldwright
