#include "search/moving_layout.h"

#include <utility>

namespace foldwright {

MovingLayout::MovingLayout(const DualGraph& graph, std::span<const int> folds)
    : graph_(&graph), tree_(graph, folds), flat_(graph, {&graph}, hang_tree(graph, folds)) {}

void MovingLayout::add_layer(const Foldable& foldable, double share) {
  order_.push_back(layer_count());
  folded_.emplace_back(*graph_, FoldedSpace(foldable, share), hang_tree(*graph_, folds()));
}

int MovingLayout::collision_count() const {
  int count = 0;
  for (const auto& layer : folded_) count += layer.collision_count();
  return count;
}

std::array<int, 2> MovingLayout::random_conflict(Random& random) const {
  std::size_t total = flat_.conflicted().size();
  for (const auto& layer : folded_) total += layer.conflicted().size();
  auto at = static_cast<std::size_t>(random.below(static_cast<int>(total)));
  const auto pick = [&](const auto& layer) {
    const int a = layer.conflicted()[at];
    const auto partners = layer.partners(a);
    return std::array{a, partners[random.below(static_cast<int>(partners.size()))]};
  };
  if (at < flat_.conflicted().size()) return pick(flat_);
  at -= flat_.conflicted().size();
  std::size_t layer = 0;
  for (; at >= folded_[layer].conflicted().size(); ++layer)
    at -= folded_[layer].conflicted().size();
  return pick(folded_[layer]);
}

std::vector<std::array<int, 2>> MovingLayout::conflicts() const {
  std::vector<std::array<int, 2>> pairs;
  const auto collect = [&](const auto& layer) {
    for (const int a : layer.conflicted()) {
      for (const int b : layer.partners(a)) {
        if (a < b) pairs.push_back({a, b});
      }
    }
  };
  collect(flat_);
  for (const auto& layer : folded_) collect(layer);
  return pairs;
}

int MovingLayout::crossing_conflicts() const {
  int crossing = flat_.crossing(tree_);
  for (const auto& layer : folded_) crossing += layer.crossing(tree_);
  return crossing;
}

int MovingLayout::try_join(int join, double limit) {
  const int overlaps = try_flat(join, limit);
  return overlaps > limit ? overlaps : overlaps + try_layers(limit - overlaps);
}

int MovingLayout::try_flat(int join, double limit) {
  tried_ = join;
  tree_.list_from(join);
  return flat_.try_join(tree_, join, limit);
}

int MovingLayout::try_layers(double limit) {
  int count = 0;
  for (std::size_t i = 0; i < order_.size() && count <= limit; ++i) {
    count += folded_[order_[i]].try_join(tree_, tried_, limit - count);
    // What refuses a swap comes sooner the next time; the verdict does not depend on the order.
    if (count > limit && i > 0) std::swap(order_[i - 1], order_[i]);
  }
  return count;
}

void MovingLayout::accept() {
  flat_.accept(tree_);
  for (auto& layer : folded_) layer.accept(tree_);
  tree_.accept(tried_);
}

void MovingLayout::refresh() {
  const RootedTree tree = hang_tree(*graph_, folds());
  tree_ = MovingTree(*graph_, folds());
  flat_ = MovingPlaces<FlatSpace>(*graph_, {graph_}, tree);
  for (auto& layer : folded_) {
    layer = MovingPlaces<FoldedSpace>(*graph_, layer.space(), tree);
  }
}

}  // namespace foldwright
