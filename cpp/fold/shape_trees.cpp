#include "fold/shape_trees.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace foldwright {
namespace {

// The largest change of a share in one step, and how often the way there is looked at.
constexpr double kStep = 0.1;
constexpr double kLookEvery = 0.025;

// Panels looked at before the search gives up: some seconds.
constexpr std::int64_t kMostLooks = 2'000'000;

// Comparing two shapes costs less than looking at one by this factor.
constexpr int kNodesPerLook = 500;

constexpr int kShortcuts = 60;

double difference(const std::vector<double>& a, const std::vector<double>& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
  return most;
}

std::vector<double> between(const std::vector<double>& a, const std::vector<double>& b, double s) {
  std::vector<double> shape;
  for (std::size_t i = 0; i < a.size(); ++i) shape.push_back(a[i] + s * (b[i] - a[i]));
  return shape;
}

}  // namespace

ShapeTrees::ShapeTrees(const Foldable& foldable, const FoldTree& folds, std::uint64_t seed)
    : foldable_(&foldable),
      folds_(&folds),
      random_(seed),
      hung_(hang_tree(*foldable.graph, folds, tree_centre(*foldable.graph, folds))) {
  for (const int end : {0, 1}) {
    trees_[end].push_back({Shape(folds.size(), end), -1});
    if (!is_free(trees_[end][0].shape)) state_ = State::kGaveUp;
  }
}

ShapeTrees::State ShapeTrees::step(std::int64_t work) {
  while (state_ == State::kRunning && work > 0) {
    const std::int64_t before = looks_;
    if (certificate_) {
      const std::int64_t slice = std::min(work, kStepSlice);
      if (certificate_->step(slice) != Certificate::State::kRunning) certify_next();
      work -= slice;
    } else if (shortcuts_left_ > 0) {
      shorten();
    } else if (!path_.empty()) {
      certify_next();
    } else if (looks_ * foldable_->graph->panel_count() > kMostLooks) {
      state_ = State::kGaveUp;
    } else {
      grow();
    }
    work -= 1 + (looks_ - before) * foldable_->graph->panel_count();
  }
  return state_;
}

bool ShapeTrees::is_free(const Shape& shape) {
  ++looks_;
  const auto angles = fold_angles(*foldable_->graph, *folds_, shape);
  return colliding_panels(*foldable_, hung_, fold_up(*foldable_, hung_, angles)).empty();
}

/// Folds at random, some of them all the way, since tight motions put folds one after the other.
ShapeTrees::Shape ShapeTrees::random_shape() {
  Shape shape;
  const double extreme = random_.uniform();
  for (std::size_t i = 0; i < folds_->size(); ++i) {
    const double share = random_.uniform();
    shape.push_back(random_.uniform() < extreme ? std::round(share) : share);
  }
  return shape;
}

int ShapeTrees::nearest(const Tree& tree, const Shape& shape) {
  looks_ += static_cast<std::int64_t>(tree.size()) / kNodesPerLook;
  int best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < static_cast<int>(tree.size()); ++i) {
    double sum = 0;
    for (std::size_t k = 0; k < shape.size(); ++k) {
      const double d = tree[i].shape[k] - shape[k];
      sum += d * d;
    }
    if (sum >= least) continue;
    least = sum;
    best = i;
  }
  return best;
}

bool ShapeTrees::way_is_free(const Shape& from, const Shape& to) {
  const int looks = static_cast<int>(difference(from, to) / kLookEvery) + 1;
  // The far end first: it is in the way most often.
  for (int i = looks; i > 0; --i) {
    if (!is_free(between(from, to, static_cast<double>(i) / looks))) return false;
  }
  return true;
}

int ShapeTrees::extend(Tree& tree, int from, const Shape& towards) {
  const double distance = difference(tree[from].shape, towards);
  Shape shape = distance <= kStep ? towards : between(tree[from].shape, towards, kStep / distance);
  if (!way_is_free(tree[from].shape, shape)) return -1;
  tree.push_back({std::move(shape), from});
  return static_cast<int>(tree.size()) - 1;
}

/// One round: a step of one tree into the open, then as many of the other one towards it as go.
void ShapeTrees::grow() {
  Tree& own = trees_[turn_];
  Tree& other = trees_[1 - turn_];
  // The straight way first; the other end now and then, for it has to be reached in the end.
  const Shape target = random_.below(4) == 0 ? other.front().shape : random_shape();
  const int reached = extend(own, nearest(own, target), target);
  if (reached != -1) {
    const Shape shape = own[reached].shape;
    int from = nearest(other, shape);
    while (from != -1 && difference(other[from].shape, shape) > 0)
      from = extend(other, from, shape);
    if (from != -1) {
      join(reached, from);
      return;
    }
  }
  turn_ = 1 - turn_;
}

/// The path through two nodes at which the trees meet.
void ShapeTrees::join(int own, int other) {
  const auto branch = [](const Tree& tree, int node) {
    std::vector<Shape> shapes;
    for (; node != -1; node = tree[node].parent) shapes.push_back(tree[node].shape);
    return shapes;
  };
  std::vector<Shape> first = branch(trees_[turn_], own);
  std::vector<Shape> second = branch(trees_[1 - turn_], other);
  if (turn_ == 1) std::swap(first, second);
  std::reverse(first.begin(), first.end());
  first.insert(first.end(), second.begin() + 1, second.end());
  path_ = std::move(first);
  shortcuts_left_ = kShortcuts;
}

/// Replaces a stretch of the path by the straight way, if that is free.
void ShapeTrees::shorten() {
  --shortcuts_left_;
  const int n = static_cast<int>(path_.size());
  if (n <= 2) return;
  int i = random_.below(n);
  int k = random_.below(n);
  if (i > k) std::swap(i, k);
  if (k - i < 2 || !way_is_free(path_[i], path_[k])) return;
  path_.erase(path_.begin() + i + 1, path_.begin() + k);
}

void ShapeTrees::certify_next() {
  if (certificate_) {
    const bool certified = certificate_->state() == Certificate::State::kCertified;
    certificate_.reset();
    if (!certified) {
      // Samples were too far apart to see this one; the next path will be another.
      path_.clear();
      certified_ = 0;
      for (Tree& tree : trees_) tree.resize(1);
      return;
    }
    ++certified_;
  }
  if (certified_ + 1 == path_.size()) {
    state_ = State::kFound;
    return;
  }
  const DualGraph& graph = *foldable_->graph;
  certificate_.emplace(*foldable_, *folds_,
                       Leg{fold_angles(graph, *folds_, path_[certified_]),
                           fold_angles(graph, *folds_, path_[certified_ + 1])});
}

}  // namespace foldwright
