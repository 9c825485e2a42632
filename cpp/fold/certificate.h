#pragma once

#include <cstdint>

#include "fold/foldable.h"

namespace foldwright {

/// One straight leg of a motion: every fold turns evenly from one angle to another.
struct Leg {
  std::vector<double> from, to;  ///< radians per hinge of the graph; those of cuts are not read
};

/// The leg from flat to the model.
Leg straight_leg(const DualGraph& graph);

/// Proves that no two faces of a net meet anywhere along a leg, or finds where some do.
///
/// Definition: each face counts eroded, as `Foldable` has it; pairs in one panel or in panels
/// joined by a fold are exempt, no others. Certified means: for every s in [0, 1], not for samples
/// only, the faces of all other pairs are disjoint.
///
/// Method: around a sampled s, no point of one face comes nearer to another by more than a bound
/// summed over the folds on the tree path between them, each turning by at most so much at so far a
/// distance. Where the faces are farther apart than that, the pair is done for the interval; else
/// the interval is halved. Cost: near-linear in faces and in the logarithm of the least distance.
class Certificate {
 public:
  /// `foldable` must outlive this object. \pre `folds` spans its graph
  Certificate(const Foldable& foldable, std::span<const int> folds, Leg leg);

  enum class State { kRunning, kCertified, kRefuted };

  /// Does about `work` microseconds' worth and says where it stands.
  State step(std::int64_t work);

  State state() const { return state_; }
  /// Where faces meet, or come so near that no bound tells them apart: a few values of s, apart
  /// from each other; late ones first.
  const std::vector<double>& counterexamples() const { return counterexamples_; }
  /// Share of the interval done, in [0, 1].
  double progress() const { return static_cast<double>(slices_done_) / slices_; }

 private:
  using Pair = std::array<int, 2>;  ///< faces, as the graph counts them
  /// An interval [s - r, s + r] and the pairs that are not done there.
  struct Interval {
    double s, r;
    int depth;
    std::vector<Pair> pairs;
  };
  enum class Verdict { kApart, kUndecided, kMeet };

  int begin_slice();
  int halve();
  /// Folds the panels up to s: all of them, or those between the pairs.
  void place_all(double s);
  int place_some(double s, std::span<const Pair> pairs);
  void place(int panel, double s);
  double reach_to_root(int face, double r) const;
  double relative_motion(int a, int b, double r);
  Verdict judge(const Pair& pair, double r);
  void push_halves(const Interval& interval, std::vector<Pair> pairs);
  void refute(double s);

  const Foldable* foldable_;
  const DualGraph* graph_;
  RootedTree tree_;
  Leg leg_;
  State state_ = State::kRunning;
  int slices_;
  int slices_done_ = 0;
  std::vector<Interval> stack_;
  std::vector<double> counterexamples_;

  std::vector<int> panel_of_;      ///< per face
  std::vector<Vec2> centroids_;    ///< per face, in its panel's coordinates
  std::vector<double> radii_;      ///< per face: of a circle about its centroid
  std::vector<double> rates_;      ///< per panel: how far its fold to the parent turns over the leg
  std::vector<int> depth_, rank_;  ///< per panel: below the root; in the tree's order

  // At the s looked at last:
  FoldedLayout places_;
  std::vector<Vec3> points_, axes_;  ///< per panel: line of the fold to its parent
  std::vector<Triangle3> faces_;
  std::vector<Vec3> centres_;

  std::vector<int> needed_;  ///< scratch
  std::vector<char> is_needed_;
  std::vector<int> path_, up_b_;
  std::vector<double> reach_;
};

}  // namespace foldwright
