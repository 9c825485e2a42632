#pragma once

#include <vector>

#include "fold/motion.h"
#include "geometry/triangle3.h"
#include "pipeline/values/result.h"

/// Nets folded up for tests, by other means than the engine's: from the model's own coordinates, by
/// Rodrigues' formula, each face eroded corner by corner, and every pair of faces looked at.
namespace foldwright::testing {

/// Whether two triangles meet, by their edges: one of them passes through the other triangle, or
/// both lie in one plane and overlap there.
bool meet_by_edges(const Triangle3& a, const Triangle3& b);

/// Each side moved inwards by `depth`, by at most a fifth of the inradius.
Triangle3 eroded_by_corners(const Triangle3& t, double depth);

/// A fold tree of a model, to be folded by any angles.
class PlainFolder {
 public:
  /// Mesh and graph must outlive this object. The root panel stays where it is in the model.
  PlainFolder(const Mesh& mesh, const DualGraph& graph, const FoldTree& folds,
              double clearance = 0.01, int root = 0);

  /// Where each face of the graph is, with each hinge folded by its angle (of cuts not read).
  std::vector<Triangle3> faces(const std::vector<double>& angles) const;
  /// The same, as faces count in collisions.
  std::vector<Triangle3> eroded_faces(const std::vector<double>& angles) const;
  /// All pairs of panels that meet, sorted; panels that a fold joins are no pair.
  std::vector<std::array<int, 2>> collisions(const std::vector<double>& angles) const;
  bool collides(const std::vector<double>& angles) const;

 private:
  std::vector<Triangle3> moved(const std::vector<Triangle3>& faces,
                               const std::vector<double>& angles) const;
  template <class Visit>
  void for_collisions(const std::vector<double>& angles, Visit&& visit) const;

  const Mesh* mesh_;
  const DualGraph* graph_;
  RootedTree tree_;
  std::vector<Triangle3> faces_, eroded_;  ///< in the model
  std::vector<int> panel_of_;
};

/// Angles between two sets, the share `s` of the way from the first.
std::vector<double> between(const std::vector<double>& from, const std::vector<double>& to,
                            double s);

/// Of `samples` + 1 evenly spaced times of a leg, those at which faces collide.
std::vector<double> colliding_times(const PlainFolder& folder, const std::vector<double>& from,
                                    const std::vector<double>& to, int samples);

/// The same for a whole motion.
std::vector<double> colliding_times(const PlainFolder& folder, const DualGraph& graph,
                                    const FoldTree& folds, const FoldMotion& motion, int samples);

/// What is wrong with how a certified piece is said to fold: keys, times, angles, the face that
/// stays. Empty when nothing is.
std::string fault_of_motion(const PieceMotion& motion, const Net& net);

/// Of `samples` + 1 times of a piece's motion, those at which faces collide. `whole`: the dual
/// graph of the result's mesh
std::vector<double> colliding_times(const JobResult& result, const DualGraph& whole,
                                    const Piece& piece, int samples);

/// Net of a graph that a search finds, with a clearance one that folds straight; empty if it gives
/// up.
FoldTree searched_net(const Mesh& mesh, const DualGraph& graph, std::uint64_t seed,
                      double clearance);

/// The first net of those that a search finds from the seeds 1, 2, .. and that does not fold
/// straight; empty when none of `seeds` does.
FoldTree net_that_does_not_fold_straight(const Mesh& mesh, const DualGraph& graph, int seeds);

}  // namespace foldwright::testing
