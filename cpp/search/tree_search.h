#pragma once

#include <cstdint>
#include <optional>

#include "geometry/random.h"
#include "search/moving_layout.h"
#include "unfold/heuristics.h"

namespace foldwright {

struct TreeSearchOptions {
  /// Heuristic trees to start from; the best one is improved. Part of them steepest edge, part flat
  /// tree.
  int starts = 40;
  /// A swap may add up to -temperature ln(u) overlaps, u uniform in (0, 1). Of whole models of 2000
  /// to 5000 faces 2 solves 52 of 54 from one seed, 0.5 two thirds; rare tight parts want less.
  double temperature = 2;
  /// Swaps without a new best before the search gives up: tight parts either come down steadily or
  /// stay stuck, and another seed then helps more than patience.
  std::int64_t patience = 20000;
  int good_enough = 0;  ///< overlaps at which the search is content
  std::uint64_t seed = 1;
};

/// Searches a net of a graph by local search on its spanning trees, from one seed.
///
/// Starts from the best of some heuristic trees. A move takes a random overlapping pair of panels,
/// cuts a fold on the tree path between them and hangs the smaller side at another hinge between
/// the two sides, which moves it rigidly; it is kept when the overlaps do not grow, and with small
/// probability when they grow a little.
class TreeSearch {
 public:
  /// Mesh and graph must outlive this object. `initial`: a fold tree to start from instead of
  /// heuristic ones, or none. \pre graph is connected
  TreeSearch(const Mesh& mesh, const DualGraph& graph, const TreeSearchOptions& options = {},
             const FoldTree& initial = {});

  enum class State { kRunning, kFound, kGaveUp };

  /// Does up to `work` units of work (a unit is about a microsecond) and says where it stands.
  State step(std::int64_t work);

  State state() const { return state_; }
  /// The best tree so far; a net when `state` is found and nothing but a net is good enough.
  const FoldTree& best() const { return best_; }
  int best_overlaps() const { return best_overlaps_; }
  std::int64_t moves() const { return moves_; }
  /// Share of the patience used up, in [0, 1].
  double impatience() const;

 private:
  /// Tries one more heuristic tree.
  void try_start();
  /// Takes a tree to start from if it is the best so far.
  void consider(FoldTree folds);
  /// Makes or refuses one swap; returns its cost in panels touched.
  int move();
  int choose_cut();
  void note_best();

  const DualGraph* graph_;
  TreeSearchOptions options_;
  HeuristicWeights weights_;
  Random random_;
  int starts_done_ = 0;
  std::optional<MovingLayout> layout_;
  FoldTree best_;
  int best_overlaps_ = -1;
  std::int64_t moves_ = 0;
  std::int64_t accepted_ = 0;
  std::int64_t best_move_ = 0;
  State state_ = State::kRunning;
  std::vector<int> path_;  ///< scratch
};

}  // namespace foldwright
