#include "repair/span_loop.h"

#include <algorithm>
#include <limits>

#include "repair/triangulate.h"

namespace foldwright {
namespace {

using Triangle = std::array<int, 3>;

// So many corners take about 20 ms.
constexpr int kMostCorners = 150;

// What the square of a connection's length costs against area: as little as leaves the choice of
// the surface to area, and of its triangles to length.
constexpr double kLengthCost = 0.02;

constexpr double kImpossible = std::numeric_limits<double>::infinity();

Vec3 area_vector(std::span<const Vec3> loop, const Triangle& t) {
  return (loop[t[1]] - loop[t[0]]).cross(loop[t[2]] - loop[t[0]]);
}

bool is_too_low(std::span<const Vec3> loop, const Triangle& t, double least_height) {
  const auto& [a, b, c] = t;
  const double longest = std::max(
      {(loop[b] - loop[a]).norm(), (loop[c] - loop[b]).norm(), (loop[a] - loop[c]).norm()});
  return area_vector(loop, t).norm() <= least_height * longest;
}

/// The best way for each chain of corners from i to j, from the short ones to the whole loop.
class Programme {
 public:
  /// `up`: triangles are to be seen from above along it; zero if that does not matter.
  Programme(std::span<const Vec3> loop, const SpanLimits& limits, const Vec3& up)
      : loop_(loop),
        limits_(limits),
        up_(up),
        count_(static_cast<int>(loop.size())),
        costs_(loop.size() * loop.size(), 0),
        tips_(loop.size() * loop.size(), -1) {
    for (int length = 2; length < count_; ++length) {
      for (int i = 0; i + length < count_; ++i) solve(i, i + length);
    }
  }

  std::vector<Triangle> triangles() const {
    std::vector<Triangle> found;
    if (costs_[at(0, count_ - 1)] < kImpossible) collect(0, count_ - 1, found);
    return found;
  }

 private:
  std::span<const Vec3> loop_;
  const SpanLimits& limits_;
  const Vec3 up_;
  const int count_;
  std::vector<double> costs_;  ///< of the chain from i to j
  std::vector<int> tips_;      ///< the third corner of the triangle at its connection

  std::size_t at(int i, int j) const { return static_cast<std::size_t>(i) * count_ + j; }

  void solve(int i, int j) {
    double& least = costs_[at(i, j)];
    least = kImpossible;
    const bool is_whole = j - i == count_ - 1;
    if (!is_whole && limits_.is_taken(i, j)) return;
    for (int k = i + 1; k < j; ++k) {
      const double parts = costs_[at(i, k)] + costs_[at(k, j)];
      if (parts >= least) continue;
      const double cost = parts + cost_of({i, k, j});
      if (cost < least) least = cost, tips_[at(i, j)] = k;
    }
    if (!is_whole) least += kLengthCost * (loop_[j] - loop_[i]).squaredNorm();
  }

  double cost_of(const Triangle& t) const {
    const Vec3 area = area_vector(loop_, t);
    if (is_too_low(loop_, t, limits_.least_height)) return kImpossible;
    if (!up_.isZero(0) && area.dot(up_) <= 0) return kImpossible;
    return 0.5 * area.norm();
  }

  void collect(int i, int j, std::vector<Triangle>& found) const {
    if (j - i < 2) return;
    const int k = tips_[at(i, j)];
    found.push_back({i, k, j});
    collect(i, k, found);
    collect(k, j, found);
  }
};

Vec3 newell_normal(std::span<const Vec3> loop) {
  Vec3 normal = Vec3::Zero();
  for (int i = 1; i + 1 < static_cast<int>(loop.size()); ++i) {
    normal += area_vector(loop, {0, i, i + 1});
  }
  return normal;
}

/// Cut ear by ear, if that keeps to the limits.
std::vector<Triangle> cut_ears(std::span<const Vec3> loop, const SpanLimits& limits) {
  std::vector<Triangle> triangles = triangulate(loop);
  const int count = static_cast<int>(loop.size());
  const auto is_bad = [&](const Triangle& t) {
    for (int i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax(t[i], t[(i + 1) % 3]);
      const bool is_edge = high - low == 1 || high - low == count - 1;
      if (!is_edge && limits.is_taken(low, high)) return true;
    }
    return is_too_low(loop, t, limits.least_height);
  };
  if (std::ranges::any_of(triangles, is_bad)) triangles.clear();
  return triangles;
}

}  // namespace

std::vector<Triangle> span_loop(std::span<const Vec3> loop, const SpanLimits& limits) {
  if (static_cast<int>(loop.size()) > kMostCorners) return cut_ears(loop, limits);
  std::vector<Triangle> triangles = Programme(loop, limits, newell_normal(loop)).triangles();
  if (triangles.empty()) triangles = Programme(loop, limits, Vec3::Zero()).triangles();
  return triangles;
}

}  // namespace foldwright
