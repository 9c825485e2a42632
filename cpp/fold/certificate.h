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

/// Work that a certificate or a search within another is given at once, in about microseconds: so
/// little that whoever steps it can stop in between, so much that looking costs nothing.
inline constexpr std::int64_t kStepSlice = 1000;

/// Proves that no two faces of a net meet anywhere along a leg, or finds where some do.
///
/// Definition: each face counts eroded, as `Foldable` has it; pairs in one panel or in panels
/// joined by a fold are exempt, no others. Certified means: for every s in [0, 1], not for samples
/// only, the faces of all other pairs are disjoint.
///
/// Method: around a sampled s, each point of a face moves relative to another face as its velocity
/// there says, up to an error that grows with the square of the time and is bounded from how far
/// the folds between the two turn. Where a direction separates the two faces all the while, the
/// pair is done for the interval; else the interval is halved. Cost: near-linear in faces and in
/// the logarithm of the least distance.
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
  /// Two faces, as the graph counts them, and the panel where their ways to the root meet.
  struct Pair {
    int a, b, meet;
  };
  /// An interval [s - r, s + r] and the pairs that are not done there.
  struct Interval {
    double s, r;
    int depth;
    std::vector<Pair> pairs;
  };
  enum class Verdict { kApart, kUndecided, kMeet };
  /// Velocity of a rigid body in motion: `turn` x p + `shift` at point p.
  struct Twist {
    Vec3 turn = Vec3::Zero();
    Vec3 shift = Vec3::Zero();
    Vec3 at(const Vec3& p) const { return turn.cross(p) + shift; }
  };

  void measure_panels();
  void find_chains();
  int glance();
  int begin_slice();
  int halve();
  std::vector<Pair> near_pairs(double r) const;
  int meeting_panel(int a, int b) const;
  /// Folds the panels up to s that lie between the pairs.
  int place_some(double s, std::span<const Pair> pairs);
  void place(int panel, double s);
  void bound_extent(double r);
  double curving(int panel, int frame) const;
  Verdict judge(const Pair& pair, double r) const;
  void push_halves(const Interval& interval, std::vector<Pair> pairs);
  void refute(double s);

  const Foldable* foldable_;
  const DualGraph* graph_;
  RootedTree tree_;
  Leg leg_;
  State state_ = State::kRunning;
  int slices_ = 1;
  int slices_done_ = 0;
  int glances_ = 0;
  std::vector<Interval> stack_;
  std::vector<double> counterexamples_;

  std::vector<int> panel_of_;      ///< per face
  std::vector<int> depth_, rank_;  ///< per panel: below the root; in the tree's order
  std::vector<int> chain_;     ///< per panel: the top of the chain that it is in; see `find_chains`
  std::vector<double> rates_;  ///< per panel: how far its fold to the parent turns over the leg
  /// Per panel, summed over the panels on the way from the root: how far folds turn, how that bends
  /// what hangs from them (see `curving`), and the panels' diameters.
  std::vector<double> turning_, bending_, length_;
  double longest_ = 0;  ///< diameter of the largest panel

  // At the s looked at last:
  FoldedLayout places_;
  std::vector<Twist> twists_;  ///< per panel, relative to the root
  std::vector<Triangle3> faces_;
  double extent_ = 0;  ///< no two points of the net are farther apart in this slice

  std::vector<int> needed_;  ///< scratch
  std::vector<char> is_needed_;
};

}  // namespace foldwright
