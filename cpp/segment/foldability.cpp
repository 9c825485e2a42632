#include "segment/foldability.h"

#include <cassert>

#include "unfold/layout.h"

namespace foldwright {
namespace {

int block_count(int size) { return (size + kSourceBlock - 1) / kSourceBlock; }

/// Adds one to the counters of the set bits: a ripple-carry adder over the planes.
void count_members(std::vector<std::vector<SourceMask>>& planes, std::size_t at, SourceMask carry) {
  for (auto& plane : planes) {
    std::uint64_t left = 0;
    for (std::size_t w = 0; w < carry.size(); ++w) {
      const std::uint64_t sum = plane[at][w] ^ carry[w];
      carry[w] &= plane[at][w];
      plane[at][w] = sum;
      left |= carry[w];
    }
    if (left == 0) return;
  }
}

}  // namespace

void FoldabilityCounts::add(const FoldabilityCounts& other) {
  if (size == 0) {
    *this = other;
    return;
  }
  assert(size == other.size && runs + other.runs < 65536);
  runs += other.runs;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    counts[i] = static_cast<std::uint16_t>(counts[i] + other.counts[i]);
  }
}

FoldabilityMatrix to_matrix(const FoldabilityCounts& counts) {
  const int n = counts.size;
  FoldabilityMatrix matrix{n, std::vector<float>(static_cast<std::size_t>(n) * n)};
  const float scale = 0.5f / static_cast<float>(counts.runs);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j <= i; ++j) {
      const std::size_t ij = static_cast<std::size_t>(i) * n + j;
      const std::size_t ji = static_cast<std::size_t>(j) * n + i;
      const int sum = counts.counts[ij] + counts.counts[ji];
      matrix.values[ij] = matrix.values[ji] = scale * static_cast<float>(sum);
    }
  }
  return matrix;
}

FoldabilityMatrix restrict_to(const FoldabilityMatrix& matrix, std::span<const int> panels) {
  FoldabilityMatrix part{static_cast<int>(panels.size()), {}};
  part.values.reserve(panels.size() * panels.size());
  for (const int row : panels) {
    for (const int column : panels) part.values.push_back(matrix(row, column));
  }
  return part;
}

FoldabilityLearner::FoldabilityLearner(const Mesh& mesh, const DualGraph& graph,
                                       const LearnOptions& options, const RunRange& runs)
    : graph_(&graph),
      options_(options),
      weights_(mesh, graph),
      first_run_(runs.first),
      run_(runs.first),
      last_run_(runs.last) {
  assert(0 <= first_run_ && first_run_ <= last_run_ && last_run_ <= 65535);
  // All directions are drawn from the start, so that a run's does not depend on the split.
  Random random(task_seed(options.seed, SeedTag::kLearning, 0, 0));
  directions_ = make_directions(mesh, options.directions, last_run_, random);
  int bits = 1;
  while ((last_run_ - first_run_) >> bits != 0) ++bits;
  const auto cells = static_cast<std::size_t>(block_count(graph.panel_count())) *
                     static_cast<std::size_t>(graph.panel_count());
  planes_.assign(bits, std::vector<SourceMask>(cells, SourceMask{}));
}

bool FoldabilityLearner::step() {
  if (run_ == last_run_) return false;
  Random random(
      task_seed(options_.seed, SeedTag::kLearning, 0, 1 + static_cast<std::uint64_t>(run_)));
  const auto weights = weights_.weights(options_.heuristic, directions_[run_], run_, random);
  const FoldTree folds = minimum_spanning_tree(*graph_, weights);
  const RootedTree tree = hang_tree(*graph_, folds);
  add(tree, overlapping_panels(*graph_, lay_out(*graph_, tree)));
  ++run_;
  return true;
}

void FoldabilityLearner::add(const RootedTree& tree, std::span<const std::array<int, 2>> overlaps) {
  UnfoldingAnalysis analysis(tree, overlaps);
  const int n = graph_->panel_count();
  for (int block = 0; block < block_count(n); ++block) {
    analysis.components_of(block * kSourceBlock, members_);
    const std::size_t row = static_cast<std::size_t>(block) * static_cast<std::size_t>(n);
    for (int panel = 0; panel < n; ++panel) count_members(planes_, row + panel, members_[panel]);
  }
}

FoldabilityCounts FoldabilityLearner::counts() const {
  const int n = graph_->panel_count();
  FoldabilityCounts result{n, runs_done(),
                           std::vector<std::uint16_t>(static_cast<std::size_t>(n) * n, 0)};
  for (int panel = 0; panel < n; ++panel) {
    std::uint16_t* row = &result.counts[static_cast<std::size_t>(panel) * n];
    for (std::size_t bit = 0; bit < planes_.size(); ++bit) {
      for (int source = 0; source < n; ++source) {
        const int block = source / kSourceBlock;
        const int lane = source % kSourceBlock;
        const SourceMask& mask =
            planes_[bit][static_cast<std::size_t>(block) * n + static_cast<std::size_t>(panel)];
        row[source] |= static_cast<std::uint16_t>(((mask[lane / 64] >> (lane % 64)) & 1) << bit);
      }
    }
  }
  return result;
}

}  // namespace foldwright
