#pragma once

#include <optional>

#include "fold/certificate.h"
#include "geometry/random.h"

namespace foldwright {

/// Searches a motion of a given net in legs: in each leg some folds turn from flat all the way,
/// evenly, while the others rest. At the waypoints between, every fold is flat or fully folded.
///
/// Local search on the leg of each fold: a fold on the way between two panels that collide at a
/// sampled shape goes to another leg, which is kept when the collisions over all samples hardly
/// grow. Where the certificate of a leg finds more collisions, samples are added.
class WaypointSearch {
 public:
  /// `foldable` and `folds` must outlive this object. \pre legs >= 2; `folds` spans the graph
  WaypointSearch(const Foldable& foldable, const FoldTree& folds, int legs, std::uint64_t seed);
  WaypointSearch(const WaypointSearch&) = delete;
  WaypointSearch& operator=(const WaypointSearch&) = delete;

  enum class State { kRunning, kFound, kGaveUp };

  /// Does about `work` microseconds' worth and says where it stands.
  State step(std::int64_t work);

  State state() const { return state_; }
  /// Shares at the keys of the motion, from all 0 to all 1. \pre found
  std::vector<std::vector<double>> keys() const;

 private:
  /// A shape that is looked at: some way along a leg.
  struct Sample {
    int leg;
    double s;
  };

  std::vector<double> shares_at(const Sample& sample) const;
  std::vector<std::array<int, 2>> collisions_at(const Sample& sample) const;
  int count_collisions(double limit);
  void propose_start();
  void move();
  void choose_fold();
  void certify();

  const Foldable* foldable_;
  const FoldTree* folds_;
  int leg_count_;
  Random random_;
  RootedTree tree_;
  std::vector<int> depth_;  ///< per panel
  std::vector<int>
      fold_of_;  ///< per panel: index of the fold to its parent in the tree; -1 at root
  std::vector<Sample> samples_;
  std::vector<int> legs_;                   ///< per fold of the tree
  int collisions_ = -1;                     ///< over all samples; -1 before the first start
  std::array<int, 2> worst_pair_ = {0, 0};  ///< a pair that collides now
  std::vector<int> best_start_;
  int starts_ = 0;
  int least_ = -1;
  int since_least_ = 0;
  std::int64_t looks_ = 0;  ///< panels, over all samples
  int certified_legs_ = 0;
  std::optional<Certificate> certificate_;
  State state_ = State::kRunning;
};

}  // namespace foldwright
