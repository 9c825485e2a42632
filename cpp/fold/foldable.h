#pragma once

#include "geometry/triangle3.h"
#include "unfold/spanning_tree.h"

namespace foldwright {

/// How much smaller faces count in collisions than they are, as a share of the mean edge length.
/// Faces that meet in a vertex, or whose cut edges meet when folded, are to be apart.
inline constexpr double kClearance = 0.01;

/// Faces no farther apart than this share of the mean edge length meet: far above rounding, which
/// would decide over faces in one plane else, and far below any clearance.
inline constexpr double kTouching = 1e-9;

/// A dual graph made ready to fold.
struct Foldable {
  const DualGraph* graph;
  /// Per hinge: its line in the coordinates of `panels[0]`, which lies on its left, and the motion
  /// that lays `panels[1]` beside it.
  std::vector<Vec3> points, axes;
  std::vector<RigidMotion3> lay;
  /// Per face: the face as it counts in collisions, in its panel's coordinates.
  std::vector<Triangle2> faces;
};

/// `graph` must outlive the result. Each face is eroded inwards by `clearance` mean edge lengths,
/// by at most a fifth of its inradius.
Foldable make_foldable(const DualGraph& graph, double clearance = kClearance);

/// Motion that puts `panel` to its neighbour across `hinge`, in the neighbour's coordinates, with
/// the hinge folded by `angle` radians: valley positive, mountain negative.
RigidMotion3 fold_beside(const Foldable& foldable, int hinge, int panel, double angle);

/// Where each panel is in space: the motion from its own plane.
using FoldedLayout = std::vector<RigidMotion3>;

/// Folds a tree up; the root stays in the plane [paper, 4.4]. `angles`: radians per hinge of the
/// graph; those of cut hinges are not read. Linear.
FoldedLayout fold_up(const Foldable& foldable, const RootedTree& tree,
                     std::span<const double> angles);

/// Each hinge's angle in the model, times `share`: 0 is flat, 1 the model.
std::vector<double> fold_angles(const DualGraph& graph, double share);

/// The same with a share for each fold of a tree; 0 for cut hinges.
std::vector<double> fold_angles(const DualGraph& graph, const FoldTree& folds,
                                std::span<const double> shares);

/// All pairs of panels (a, b), a < b, of which faces meet, eroded as `foldable` has them, sorted.
/// Panels joined by a fold of the tree are no pair: a hinge keeps them together.
std::vector<std::array<int, 2>> colliding_panels(const Foldable& foldable, const RootedTree& tree,
                                                 const FoldedLayout& layout);

/// Whether faces meet in the model itself that no hinge joins: then no motion can be certified.
bool meets_itself(const Foldable& foldable);

}  // namespace foldwright
