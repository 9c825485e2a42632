#include "search/net_annealing.h"

#include <gtest/gtest.h>

#include "meshes.h"
#include "search/tree_search.h"
#include "trees.h"

namespace foldwright::testing {
namespace {

/// Counts cut hinges with an even number: simple enough to be known without geometry.
class EvenCuts : public TreeCost {
 public:
  explicit EvenCuts(const DualGraph& graph) : is_fold_(graph.hinge_count(), 0) {}

  void lay(const FoldTree& folds, const Layout&) override {
    std::ranges::fill(is_fold_, 0);
    for (const int h : folds) is_fold_[h] = 1;
    cost_ = 0;
    for (std::size_t h = 0; h < is_fold_.size(); h += 2) cost_ += is_fold_[h] ? 0 : 1;
  }
  double cost() const override { return cost_; }
  double try_swap(const TreeSwap& swap, double) override {
    trial_ = swap;
    then_ = cost_ + (swap.cut % 2 == 0 ? 1 : 0) - (swap.join % 2 == 0 ? 1 : 0);
    return then_;
  }
  void accept() override {
    is_fold_[trial_.cut] = 0;
    is_fold_[trial_.join] = 1;
    cost_ = then_;
  }
  int worst_cut(Random&) const override { return -1; }
  std::int64_t work() const override { return 1; }

 private:
  std::vector<char> is_fold_;
  double cost_ = 0, then_ = 0;
  TreeSwap trial_{};
};

double even_cuts(const DualGraph& graph, const FoldTree& folds) {
  EvenCuts cost(graph);
  cost.lay(folds, {});
  return cost.cost();
}

FoldTree straight_net(const Mesh& mesh, const DualGraph& graph, double clearance) {
  TreeSearch search(mesh, graph, {.clearance = clearance});
  while (search.step(100000) == TreeSearch::State::kRunning) continue;
  EXPECT_EQ(search.state(), TreeSearch::State::kFound);
  return search.best();
}

FoldTree annealed(const DualGraph& graph, const FoldTree& net, const AnnealingOptions& options,
                  std::int64_t slice = 100000) {
  NetAnnealing annealing(graph, net, std::make_unique<EvenCuts>(graph), options);
  double progress = 0;
  while (annealing.step(slice) == NetAnnealing::State::kRunning) {
    EXPECT_GE(annealing.progress(), progress);
    progress = annealing.progress();
  }
  EXPECT_EQ(annealing.best_cost(), even_cuts(graph, annealing.best()));
  return annealing.best();
}

TEST(NetAnnealing, MakesANetCheaperAndKeepsItANet) {
  for (const int faces : {60, 150, 300}) {
    SCOPED_TRACE(faces);
    const Mesh mesh = bumpy_sphere(faces);
    const DualGraph graph = build_dual_graph(mesh);
    const FoldTree net = straight_net(mesh, graph, 0);
    const FoldTree best = annealed(graph, net, {.work = 200000, .seed = 3});
    EXPECT_TRUE(is_net(mesh, graph, best));
    EXPECT_LT(even_cuts(graph, best), even_cuts(graph, net));
  }
}

TEST(NetAnnealing, KeepsANetFoldingStraight) {
  for (const int faces : {60, 200}) {
    SCOPED_TRACE(faces);
    const Mesh mesh = bumpy_sphere(faces);
    const DualGraph graph = build_dual_graph(mesh);
    const FoldTree net = straight_net(mesh, graph, kClearance);
    const FoldTree best =
        annealed(graph, net, {.work = 400000, .clearance = kClearance, .seed = 5});
    EXPECT_TRUE(is_net(mesh, graph, best));
    EXPECT_LT(even_cuts(graph, best), even_cuts(graph, net));
    const Foldable exact = make_foldable(graph, kClearance);
    Certificate certificate(exact, best, straight_leg(graph));
    while (certificate.step(100000) == Certificate::State::kRunning) continue;
    EXPECT_EQ(certificate.state(), Certificate::State::kCertified);
  }
}

TEST(NetAnnealing, GivesTheSameNetInAnySlices) {
  const Mesh mesh = bumpy_sphere(120);
  const DualGraph graph = build_dual_graph(mesh);
  const FoldTree net = straight_net(mesh, graph, kClearance);
  const AnnealingOptions options = {.work = 100000, .clearance = kClearance, .seed = 9};
  EXPECT_EQ(annealed(graph, net, options, 1), annealed(graph, net, options, 1 << 30));
}

TEST(NetAnnealing, HasNothingToDoWithoutWorkOrWithoutAChoice) {
  const Mesh mesh = bumpy_sphere(60);
  const DualGraph graph = build_dual_graph(mesh);
  const FoldTree net = straight_net(mesh, graph, 0);
  EXPECT_EQ(annealed(graph, net, {}), net);
  const Mesh strip = accordion({1, 2, 3});
  const DualGraph chain = build_dual_graph(strip);
  const FoldTree only = straight_net(strip, chain, 0);
  EXPECT_EQ(annealed(chain, only, {.work = 1000}), only);
}

}  // namespace
}  // namespace foldwright::testing
