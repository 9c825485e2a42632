#pragma once

#include <cstdint>
#include <vector>

#include "segment/analyze_unfolding.h"
#include "unfold/directions.h"
#include "unfold/heuristics.h"

namespace foldwright {

/// How often panel v was in the component of source f, over some runs; row-major by v.
struct FoldabilityCounts {
  int size = 0;
  int runs = 0;
  std::vector<std::uint16_t> counts;  ///< [v * size + f]; at most 65535 runs

  void add(const FoldabilityCounts& other);
};

/// The foldability matrix M [paper, 4.1.2]: the share of runs in which two faces unfold together,
/// (count(f, f') + count(f', f)) / (2 runs). Symmetric, entries in [0, 1], ones on the diagonal.
struct FoldabilityMatrix {
  int size = 0;
  std::vector<float> values;  ///< row-major

  float operator()(int row, int column) const {
    return values[static_cast<std::size_t>(row) * size + column];
  }
};

FoldabilityMatrix to_matrix(const FoldabilityCounts& counts);

/// The rows and columns of some panels, in their order.
FoldabilityMatrix restrict_to(const FoldabilityMatrix& matrix, std::span<const int> panels);

/// M between the panels of a graph when it was learned on another one (a proxy, or a larger graph):
/// each panel has the row of the one that stands for it.
struct CarriedFoldability {
  const FoldabilityMatrix& matrix;
  std::span<const int> rows;

  float operator()(int a, int b) const { return matrix(rows[a], rows[b]); }
};

struct LearnOptions {
  Heuristic heuristic = Heuristic::kSteepestEdge;
  DirectionSet directions = DirectionSet::kRandom;
  int runs = 400;  ///< 1 to 65535; the paper's setting (5.1)
  std::uint64_t seed = 1;
};

/// Learning runs [first, last).
struct RunRange {
  int first, last;
};

/// Learns from unfoldings run by run [paper, 4.1]: the range of runs may be split over several
/// learners, whose counts add up to the same matrix.
class FoldabilityLearner {
 public:
  /// Learns some of the runs of `options`. Mesh and graph must outlive this object.
  /// \pre graph is connected
  FoldabilityLearner(const Mesh& mesh, const DualGraph& graph, const LearnOptions& options,
                     const RunRange& runs);

  /// Does one run; false when none was left.
  bool step();
  int runs_done() const { return run_ - first_run_; }

  /// Counts of the runs done so far.
  FoldabilityCounts counts() const;

 private:
  void add(const RootedTree& tree, std::span<const std::array<int, 2>> overlaps);

  const DualGraph* graph_;
  LearnOptions options_;
  HeuristicWeights weights_;
  std::vector<Vec3> directions_;
  int first_run_, run_, last_run_;
  std::vector<SourceMask> members_;  ///< scratch
  /// Bit-sliced counters: plane k holds bit k of every count; [k][block * size + panel].
  std::vector<std::vector<SourceMask>> planes_;
};

}  // namespace foldwright
