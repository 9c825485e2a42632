#pragma once

#include <span>
#include <vector>

#include "pipeline/values/job_start.h"
#include "pipeline/values/task.h"

namespace foldwright {

/// Parts and nets of an earlier result while they are edited one by one. Faces without a net are
/// to be searched.
struct EarlierNets {
  std::vector<int> labels;  ///< per face of the mesh: its part
  int part_count = 0;
  std::vector<SavedNet> nets;
};

bool is_same_edge(const EdgeName& a, const EdgeName& b);

/// The fold trees of earlier nets, on the graph of the whole model, and the changes to them that
/// edits are made of. Nets that come of a change stay where they lay on paper.
class NetTrees {
 public:
  /// `scale`: millimetres per model unit of the nets' places. What is given must outlive this.
  NetTrees(const Surface& surface, double scale, EarlierNets& nets)
      : surface_(surface), graph_(surface.graph), scale_(scale), nets_(nets) {}

  /// The hinge of the model's graph that an edge lies on. \throw InputError "no-edge",
  /// "open-border", "inside-panel", and "locked" for one that is never to be a fold
  int hinge_at(const EdgeName& edge) const;
  /// The net at one side of a hinge, 0 or 1. \throw InputError "no-net" if there is none yet
  std::size_t net_at(int hinge, int side) const;
  bool folds_at(int hinge) const;

  /// Panels of the model that a net has, ascending, and its folds as hinges of the model.
  struct Tree {
    std::vector<int> panels, hinges;
  };
  Tree tree_of(std::size_t net) const;
  /// Folds of a tree on the way between the panels of a hinge.
  std::vector<int> loop_of(const Tree& tree, int hinge) const;
  /// All other hinges between the two sides that a tree has without one of its folds.
  std::vector<int> hinges_across(const Tree& tree, int fold) const;

  /// Lets a net fall in two at one of its folds. Both keep their folds and motion.
  void cut(std::size_t net, int hinge);
  /// Puts a tree over panels of a net, and maybe of others, in its stead if no faces overlap.
  /// Returns the faces that do.
  std::vector<int> replace(std::size_t net, const Tree& tree);

 private:
  const Surface& surface_;
  const DualGraph& graph_;
  double scale_;
  EarlierNets& nets_;
};

}  // namespace foldwright
