#pragma once

#include "fold/foldable.h"
#include "geometry/box_grid.h"
#include "search/moving_tree.h"
#include "unfold/layout.h"

namespace foldwright {

/// A graph laid flat, as `MovingPlaces` needs to know it.
struct FlatSpace {
  static constexpr int kDimensions = 2;
  using Motion = RigidMotion2;
  using Face = Triangle2;

  const DualGraph* graph;

  const Face& face(int i) const { return graph->triangles[i]; }
  Face placed(const Motion& motion, const Face& face) const { return moved(motion, face); }
  Box2 box(const Face& face) const { return box_of(face); }
  Motion beside(int hinge, int panel) const { return graph->lay_beside(hinge, panel); }
  bool collide(const Face& a, const Face& b) const;
  /// Whether panels joined by a fold are spared.
  static constexpr bool kSparesJoined = false;

  std::vector<Motion> lay_out(const RootedTree& tree) const;
  std::vector<std::array<int, 2>> collisions(const RootedTree& tree,
                                             const std::vector<Motion>& places) const;
};

/// A graph with every fold at the same share of its angle.
class FoldedSpace {
 public:
  static constexpr int kDimensions = 3;
  using Motion = RigidMotion3;
  using Face = Triangle3;

  /// `foldable` must outlive this object. `share`: of each fold's angle, in [0, 1]
  FoldedSpace(const Foldable& foldable, double share);

  double share() const { return share_; }
  const Face& face(int i) const { return faces_[i]; }
  Face placed(const Motion& motion, const Face& face) const { return moved(motion, face); }
  Box3 box(const Face& face) const { return box_of(face).grown(tolerance_); }
  Motion beside(int hinge, int panel) const {
    return foldable_->graph->hinges[hinge].panels[1] == panel ? beside_[hinge]
                                                              : beside_[hinge].inverse();
  }
  bool collide(const Face& a, const Face& b) const { return triangles_meet(a, b, tolerance_); }
  static constexpr bool kSparesJoined = true;

  std::vector<Motion> lay_out(const RootedTree& tree) const;
  std::vector<std::array<int, 2>> collisions(const RootedTree& tree,
                                             const std::vector<Motion>& places) const;

 private:
  const Foldable* foldable_;
  double share_;
  double tolerance_;
  std::vector<Face> faces_;
  std::vector<Motion> beside_;
};

/// Where the panels of a moving tree lie in one space, and which of them collide.
///
/// A swap moves one side of the tree rigidly, so only collisions between the sides change. Cost of
/// a trial: linear in the side that moves.
template <class Space>
class MovingPlaces {
 public:
  /// `graph` must outlive this object.
  MovingPlaces(const DualGraph& graph, Space space, const RootedTree& tree);

  const Space& space() const { return space_; }
  int collision_count() const { return collision_count_; }
  /// Where each panel lies.
  const std::vector<typename Space::Motion>& places() const { return places_; }
  /// What the last trial cost beyond that of as many panels of one face each, in such panels. A
  /// panel of many triangles costs more, and above all where they reach so far that all are near
  /// all others.
  std::int64_t trial_excess() const;
  /// How the selected side moved in the last trial.
  const typename Space::Motion& trial_motion() const { return trial_.motion; }
  /// Panels that collide with some other, in no particular (but reproducible) order.
  std::span<const int> conflicted() const { return conflicted_; }
  std::span<const int> partners(int panel) const { return partners_[panel]; }

  /// Collisions between the two sides of `tree` as they lie now.
  int crossing(const MovingTree& tree) const;
  /// Collisions between the sides if the selected one were hung at `join`; stops counting above
  /// `limit` and then returns more than it.
  /// \pre `tree` lists the selected side from there
  int try_join(MovingTree& tree, int join, double limit);
  /// Moves the selected side as tried last, before the tree itself accepts.
  /// \pre the count of that trial was completed
  void accept(const MovingTree& tree);

 private:
  static constexpr int kDimensions = Space::kDimensions;
  using Motion = typename Space::Motion;
  using Face = typename Space::Face;

  struct Trial {
    Motion motion;
    int hung, onto;
    std::vector<std::array<int, 2>> collisions;  ///< (moved panel, panel that stays)
    std::int64_t panels, faces, visits;          ///< moved, their faces, and faces beside those
  };

  double mean_box_size() const;
  void add_collision(int a, int b);
  void remove_collision(int a, int b);
  void forget_partner(int panel, int partner);
  /// Counts what one panel meets when moved; false when `limit` is exceeded.
  bool count_panel(const MovingTree& tree, int panel, double limit);
  void move_panel(int panel, const Motion& place);

  const DualGraph* graph_;
  Space space_;
  std::vector<Motion> places_;
  std::vector<int> panel_of_;  ///< per face
  std::vector<Face> faces_;    ///< placed
  std::vector<Box<kDimensions>> boxes_;
  BoxGrid<kDimensions> grid_;
  std::vector<std::vector<int>> partners_;
  std::vector<int> conflicted_, conflict_slot_;
  int collision_count_ = 0;
  std::vector<std::uint32_t> seen_;  ///< per face, within one query
  std::uint32_t query_ = 0;
  Trial trial_;
};

extern template class MovingPlaces<FlatSpace>;
extern template class MovingPlaces<FoldedSpace>;

}  // namespace foldwright
