#pragma once

#include <cstdint>
#include <optional>

#include "geometry/random.h"
#include "search/certified_layers.h"
#include "unfold/heuristics.h"

namespace foldwright {

struct TreeSearchOptions {
  /// Heuristic trees to start from; the best one is improved. Part of them steepest edge, part flat
  /// tree.
  int starts = 40;
  /// A swap may add up to -temperature ln(u) conflicts, u uniform in (0, 1). Of whole models of
  /// 2000 to 5000 faces 2 solves 52 of 54 from one seed, 0.5 two thirds; rare tight parts want
  /// less.
  double temperature = 2;
  /// Swaps without a new best before the search gives up: tight parts either come down steadily or
  /// stay stuck, and another seed then helps more than patience. Fewer where panels have so many
  /// faces that each swap costs many times what it usually does.
  std::int64_t patience = 20000;
  int good_enough = 0;  ///< conflicts at which the search is content
  /// Search a net that also folds up straight, with this clearance in mean edge lengths; 0: any net
  /// will do.
  double clearance = 0;
  std::uint64_t seed = 1;
};

/// Searches a net of a graph by local search on its spanning trees, from one seed.
///
/// Starts from the best of some heuristic trees. A move takes a random pair of panels in conflict,
/// cuts a fold on the tree path between them and hangs the smaller side at another hinge between
/// the two sides, which moves it rigidly; it is kept when the conflicts do not grow, and with small
/// probability when they grow a little.
///
/// Conflicts are overlaps in the plane. With a clearance, once a net is found, they are also
/// collisions in space at a few shares of the folding, and where a certificate of the whole motion
/// finds more, at those, until a net is certified to fold straight.
class TreeSearch {
 public:
  /// Mesh and graph must outlive this object. `initial`: a fold tree to start from instead of
  /// heuristic ones, or none. \pre graph is connected
  TreeSearch(const Mesh& mesh, const DualGraph& graph, const TreeSearchOptions& options = {},
             const FoldTree& initial = {});
  // The layout refers to what stands beside it.
  TreeSearch(const TreeSearch&) = delete;
  TreeSearch& operator=(const TreeSearch&) = delete;

  enum class State { kRunning, kFound, kGaveUp };

  /// Does up to `work` units of work (a unit is about a microsecond) and says where it stands.
  State step(std::int64_t work);

  State state() const { return state_; }
  /// The best tree so far: with fewest overlaps, and then fewest collisions.
  const FoldTree& best() const { return best_; }
  int best_overlaps() const { return best_overlaps_; }
  /// Collisions of the best tree while it folds, at the samples looked at; 0 before there is a net.
  int best_collisions() const { return best_collisions_; }
  /// How far the best tree is from what is searched, in conflicts; 0 once it is found.
  int shortfall() const;
  /// Pairs of panels of the best tree that are in conflict, some several times.
  std::vector<std::array<int, 2>> conflicts() const;
  std::int64_t moves() const { return moves_; }
  /// Share of the patience used up, in [0, 1].
  double impatience() const;

 private:
  /// Tries one more heuristic tree.
  void try_start();
  /// Takes a tree to start from if it is the best so far.
  void consider(FoldTree folds);
  /// Makes or refuses one swap; returns its cost in panels touched.
  std::int64_t move();
  bool is_out_of_patience() const;
  std::optional<int> choose_cut();
  void note_progress();
  void note_best();
  void finish_or_fold();
  void judge_certificate();
  void look_at_layers();

  const DualGraph* graph_;
  TreeSearchOptions options_;
  HeuristicWeights weights_;
  Random random_;
  std::optional<CertifiedLayers> layers_;  ///< with a clearance
  int starts_done_ = 0;
  std::optional<MovingLayout> layout_;
  FoldTree best_;
  int best_overlaps_ = -1;
  int best_collisions_ = 0;
  int least_conflicts_ = -1;  ///< in the layers there are
  std::int64_t moves_ = 0;
  std::int64_t accepted_ = 0;
  std::int64_t best_move_ = 0;
  std::int64_t touched_ = 0;  ///< panels, since the last new best
  State state_ = State::kRunning;
  std::vector<int> path_;  ///< scratch
};

}  // namespace foldwright
