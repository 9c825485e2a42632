#include "repair/weld.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace foldwright {
namespace {

/// Cells of a grid, each with a chain of the positions in it.
class Grid {
 public:
  Grid(std::span<const Vec3> positions, double tolerance)
      // Cells much wider than the tolerance: a point has to look into one cell, rarely into more.
      : positions_(positions),
        tolerance_(tolerance),
        cell_(std::max(8 * tolerance, kSmallestCell)),
        next_(positions.size(), -1) {}

  void insert(int index) {
    const auto [entry, is_new] = first_.try_emplace(key(cell_of(positions_[index])), index);
    if (!is_new) {
      next_[index] = entry->second;
      entry->second = index;
    }
  }

  /// Nearest inserted position within the tolerance, the earliest of equally near ones; or -1.
  int nearest(const Vec3& position) const {
    const Vec3 margin = Vec3::Constant(tolerance_);
    const Cell low = cell_of(position - margin);
    const Cell high = cell_of(position + margin);
    int best = -1;
    double best_distance = tolerance_ * tolerance_;
    for (std::int64_t x = low[0]; x <= high[0]; ++x) {
      for (std::int64_t y = low[1]; y <= high[1]; ++y) {
        for (std::int64_t z = low[2]; z <= high[2]; ++z) {
          search({x, y, z}, position, best, best_distance);
        }
      }
    }
    return best;
  }

 private:
  using Cell = std::array<std::int64_t, 3>;

  // With coordinates within +-1 this many cells per axis fit into 21 bits.
  static constexpr double kSmallestCell = 4e-6;

  std::span<const Vec3> positions_;
  double tolerance_;
  double cell_;
  std::unordered_map<std::uint64_t, int> first_;  // looked up only, never iterated
  std::vector<int> next_;

  Cell cell_of(const Vec3& p) const {
    return {static_cast<std::int64_t>(std::floor(p.x() / cell_)),
            static_cast<std::int64_t>(std::floor(p.y() / cell_)),
            static_cast<std::int64_t>(std::floor(p.z() / cell_))};
  }

  static std::uint64_t key(const Cell& cell) {
    constexpr std::uint64_t kMask = (1 << 21) - 1;
    return (static_cast<std::uint64_t>(cell[0]) & kMask) |
           (static_cast<std::uint64_t>(cell[1]) & kMask) << 21 |
           (static_cast<std::uint64_t>(cell[2]) & kMask) << 42;
  }

  void search(const Cell& cell, const Vec3& position, int& best, double& best_distance) const {
    const auto entry = first_.find(key(cell));
    if (entry == first_.end()) return;
    for (int index = entry->second; index != -1; index = next_[index]) {
      const double distance = (positions_[index] - position).squaredNorm();
      if (distance < best_distance || (distance == best_distance && (best == -1 || index < best))) {
        best = index;
        best_distance = distance;
      }
    }
  }
};

}  // namespace

std::vector<int> weld(std::span<const Vec3> positions, double tolerance) {
  Grid grid(positions, tolerance);
  std::vector<int> standing_for(positions.size());
  for (int i = 0; i < static_cast<int>(positions.size()); ++i) {
    const int nearest = grid.nearest(positions[i]);
    standing_for[i] = nearest == -1 ? i : nearest;
    if (nearest == -1) grid.insert(i);
  }
  return standing_for;
}

}  // namespace foldwright
