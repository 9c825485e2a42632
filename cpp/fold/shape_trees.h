#pragma once

#include <optional>

#include "fold/certificate.h"
#include "geometry/random.h"

namespace foldwright {

/// Searches a motion of a given net from shape to shape, by two trees of shapes without collisions
/// that grow towards each other, one from flat and one from the model (rapidly exploring random
/// trees, Kuffner and LaValle 2000). A shape is the share of each fold. The last resort: it knows
/// nothing of the net, and needs many looks.
class ShapeTrees {
 public:
  /// `foldable` and `folds` must outlive this object. \pre `folds` spans the graph
  ShapeTrees(const Foldable& foldable, const FoldTree& folds, std::uint64_t seed);
  ShapeTrees(const ShapeTrees&) = delete;
  ShapeTrees& operator=(const ShapeTrees&) = delete;

  enum class State { kRunning, kFound, kGaveUp };

  /// Does about `work` microseconds' worth and says where it stands.
  State step(std::int64_t work);

  State state() const { return state_; }
  /// Shares at the keys of the motion, from all 0 to all 1. \pre found
  const std::vector<std::vector<double>>& keys() const { return path_; }

 private:
  using Shape = std::vector<double>;
  struct Node {
    Shape shape;
    int parent;
  };
  using Tree = std::vector<Node>;

  bool is_free(const Shape& shape);
  Shape random_shape();
  int nearest(const Tree& tree, const Shape& shape);
  /// Grows a tree by one step towards a shape; the new node, or -1 if something is in the way.
  int extend(Tree& tree, int from, const Shape& towards);
  bool way_is_free(const Shape& from, const Shape& to);
  void grow();
  void join(int own, int other);
  void shorten();
  void certify_next();

  const Foldable* foldable_;
  const FoldTree* folds_;
  Random random_;
  RootedTree hung_;
  std::array<Tree, 2> trees_;  ///< from flat, from the model
  int turn_ = 0;
  std::int64_t looks_ = 0;
  std::vector<Shape> path_;
  int shortcuts_left_ = 0;
  std::size_t certified_ = 0;  ///< legs of the path
  std::optional<Certificate> certificate_;
  State state_ = State::kRunning;
};

}  // namespace foldwright
