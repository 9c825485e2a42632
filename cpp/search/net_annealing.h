#pragma once

#include <memory>
#include <optional>

#include "search/certified_layers.h"
#include "unfold/tree_cost.h"

namespace foldwright {

struct AnnealingOptions {
  std::int64_t work = 0;  ///< to spend, in about microseconds
  /// Of the cost, at the beginning and at the end.
  double hot = 0.3, cold = 0.02;
  /// Keep the net folding straight with this clearance in mean edge lengths; 0: any net will do.
  double clearance = 0;
  std::uint64_t seed = 1;
};

/// Makes a net cheaper by simulated annealing over its spanning trees, and keeps it a net.
///
/// A move makes a fold of a cut hinge, often one that the cost is worst off with, and cuts another
/// fold of the loop that closes; moves that overlap are refused. With a clearance so are those that
/// collide at a few shares of the folding. Now and then the whole motion is certified; where that
/// fails, the shares at fault are looked at as well, and what collides there is searched away. The
/// outcome is the cheapest net that passed, the one it began with at worst.
class NetAnnealing {
 public:
  /// Mesh and graph must outlive this object. \pre `net` has no overlap, and with a clearance is
  /// certified to fold straight
  NetAnnealing(const DualGraph& graph, FoldTree net, std::unique_ptr<TreeCost> cost,
               const AnnealingOptions& options);
  NetAnnealing(const NetAnnealing&) = delete;
  NetAnnealing& operator=(const NetAnnealing&) = delete;

  enum class State { kRunning, kDone };

  /// Does about `work` microseconds' worth and says where it stands.
  State step(std::int64_t work);
  State state() const { return state_; }

  /// The cheapest net found so far that passed.
  const FoldTree& best() const { return best_; }
  double best_cost() const { return best_cost_; }
  double first_cost() const { return first_cost_; }
  TreeCost& cost() { return *cost_; }
  std::int64_t moves() const { return moves_; }
  /// Share of the work done, in [0, 1].
  double progress() const;

 private:
  double temperature() const;
  std::int64_t move();
  std::int64_t mend();
  bool choose_swap();
  void refresh();
  void begin_check();
  void end_check();
  void restart_from_best();

  const DualGraph* graph_;
  AnnealingOptions options_;
  std::unique_ptr<TreeCost> cost_;
  Random random_;
  std::optional<CertifiedLayers> layers_;  ///< with a clearance
  std::optional<MovingLayout> layout_;
  FoldTree best_;
  double best_cost_ = 0, first_cost_ = 0;
  std::int64_t spent_ = 0, next_check_ = 0, mending_ = 0;
  std::int64_t moves_ = 0, accepted_ = 0;
  State state_ = State::kRunning;
  int join_ = -1;
  std::vector<int> path_;
};

}  // namespace foldwright
