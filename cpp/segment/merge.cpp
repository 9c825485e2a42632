#include "segment/merge.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <set>

#include "segment/concave_geodesic.h"

namespace foldwright {
namespace {

/// Regions under merging: a dense matrix of summed affinities, shrinking by rows.
class Regions {
 public:
  Regions(const DualGraph& graph, std::vector<double> affinity)
      : size_(graph.panel_count()),
        count_(size_),
        between_(std::move(affinity)),
        volume_(size_, 0),
        label_(size_),
        neighbours_(size_) {
    for (int i = 0; i < size_; ++i) {
      label_[i] = i;
      for (int j = 0; j < size_; ++j) volume_[i] += at(i, j);
    }
    for (const Hinge& hinge : graph.hinges) {
      neighbours_[hinge.panels[0]].insert(hinge.panels[1]);
      neighbours_[hinge.panels[1]].insert(hinge.panels[0]);
    }
    best_.resize(size_);
    for (int i = 0; i < size_; ++i) update_best(i);
  }

  struct Pair {
    int low = -1, high = -1;
    double cost = 0;
  };

  /// The adjacent pair that is cheapest to merge; `low` is -1 when no two are adjacent.
  Pair cheapest() const {
    Pair least;
    for (int i = 0; i < size_; ++i) {
      if (best_[i].high != -1 && (least.low == -1 || best_[i].cost < least.cost)) least = best_[i];
    }
    return least;
  }

  void merge(const Pair& pair) {
    const int x = pair.low;
    const int y = pair.high;
    for (int j = 0; j < size_; ++j) at(x, j) += at(y, j);
    for (int j = 0; j < size_; ++j) at(j, x) += at(j, y);
    volume_[x] += volume_[y];
    for (int& label : label_) label = label == y ? x : label;
    for (const int next : neighbours_[y]) {
      neighbours_[next].erase(y);
      if (next == x) continue;
      neighbours_[next].insert(x);
      neighbours_[x].insert(next);
    }
    neighbours_[y].clear();
    best_[y] = {};
    update_best(x);
    // Only pairs with x have a new cost, and those with y are gone.
    for (const int next : neighbours_[x]) update_best(next);
    --count_;
  }

  int count() const { return count_; }
  Labels labels() const { return renumbered(label_); }

 private:
  double& at(int i, int j) { return between_[static_cast<std::size_t>(i) * size_ + j]; }
  double at(int i, int j) const { return between_[static_cast<std::size_t>(i) * size_ + j]; }

  /// Share of a region's affinity that stays within; a face without any has none to lose.
  static double association(double within, double volume) {
    return volume > 0 ? within / volume : 0;
  }

  double cost(int x, int y) const {
    const double apart = association(at(x, x), volume_[x]) + association(at(y, y), volume_[y]);
    const double together = at(x, x) + at(y, y) + 2 * at(x, y);
    return apart - association(together, volume_[x] + volume_[y]);
  }

  /// Cheapest partner above `x`; the lower partner among equals.
  void update_best(int x) {
    best_[x] = {};
    for (auto it = neighbours_[x].upper_bound(x); it != neighbours_[x].end(); ++it) {
      const double c = cost(x, *it);
      if (best_[x].high == -1 || c < best_[x].cost) best_[x] = {x, *it, c};
    }
  }

  int size_, count_;
  std::vector<double> between_;
  std::vector<double> volume_;
  std::vector<int> label_;
  std::vector<std::set<int>> neighbours_;
  std::vector<Pair> best_;
};

std::vector<double> affinities(const FoldabilityMatrix& matrix, std::span<const float> geodesic,
                               int power, double falloff) {
  std::vector<double> affinity(matrix.values.size());
  for (std::size_t i = 0; i < affinity.size(); ++i) {
    double value = std::exp(-geodesic[i] / falloff);
    for (int k = 0; k < power; ++k) value *= matrix.values[i];
    affinity[i] = value;
  }
  // A face's affinity to itself would hold outliers, which unfold with hardly any other, apart.
  const auto stride = static_cast<std::size_t>(matrix.size) + 1;
  for (std::size_t i = 0; i < affinity.size(); i += stride) affinity[i] = 0;
  return affinity;
}

}  // namespace

Labels merge_clusters(const Mesh& mesh, const DualGraph& graph, const FoldabilityMatrix& matrix,
                      const MergeOptions& options) {
  assert(matrix.size == graph.panel_count());
  const bool estimate = options.parts == 0;
  const int power = estimate ? options.estimate_power : options.power;
  const std::vector<float> geodesic = concave_geodesic(mesh, graph);
  Regions regions(graph, affinities(matrix, geodesic, power, options.falloff));
  while (regions.count() > std::max(options.parts, 1)) {
    const Regions::Pair pair = regions.cheapest();
    if (pair.low == -1) break;
    if (estimate && pair.cost > options.stop && regions.count() <= options.most_estimated) break;
    regions.merge(pair);
  }
  return regions.labels();
}

}  // namespace foldwright
