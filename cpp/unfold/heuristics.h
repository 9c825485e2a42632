#pragma once

#include <vector>

#include "geometry/random.h"
#include "unfold/spanning_tree.h"

namespace foldwright {

/// How dual edges are weighted [paper, 3.2 and Table 2]. The hybrid alternates between the first
/// two from run to run.
enum class Heuristic { kSteepestEdge, kFlatTree, kHybrid, kRandom };

/// Weights of the heuristics for one graph, whose minimum spanning tree is the fold tree; keeps the
/// primal edges sorted by vertex.
class HeuristicWeights {
 public:
  /// Both must outlive this object.
  HeuristicWeights(const Mesh& mesh, const DualGraph& graph);

  /// Steepest edge: from every vertex but the top one, the steepest edge upwards is cut (weight 1),
  /// all others are folds (weight 0). Vertices on a border are cut free already. Where the minimum
  /// spanning tree has a choice between equal weights, the steeper edge is cut.
  /// `direction`: unit vector. One weight per hinge, in [0, 2).
  std::vector<double> steepest_edge(const Vec3& direction) const;

  /// Flat tree: |<e, c>| / (|e| |c|), so that edges across the direction are folded and those along
  /// it are cut. One weight per hinge, in [0, 1].
  std::vector<double> flat_tree(const Vec3& direction) const;

  /// Weights of one run: `run` decides which heuristic a hybrid takes, `random` fills a random one.
  std::vector<double> weights(Heuristic heuristic, const Vec3& direction, int run,
                              Random& random) const;

 private:
  struct Spoke {
    int hinge;
    Vec3 direction;  ///< unit vector from the vertex along the edge
  };

  const DualGraph* graph_;
  std::vector<Vec3> hinge_directions_;  ///< unit vector along each hinge
  std::vector<Spoke> spokes_;           ///< by vertex that needs a cut
  std::vector<int> first_spoke_ = {0};  ///< CSR over those vertices
  std::vector<Vec3> positions_;         ///< of those vertices
};

}  // namespace foldwright
