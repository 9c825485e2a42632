#include "search/certified_layers.h"

#include <gtest/gtest.h>

#include "meshes.h"
#include "trees.h"
#include "unfold/spanning_tree.h"

namespace foldwright::testing {
namespace {

constexpr double kClearance = 0.01;

FoldTree any_tree(const DualGraph& graph) {
  return minimum_spanning_tree(graph, std::vector<double>(graph.hinge_count(), 1));
}

TEST(CertifiedLayers, LooksAtEachShareOnce) {
  const DualGraph graph = build_dual_graph(cube());
  CertifiedLayers layers(graph, kClearance);
  MovingLayout layout(graph, any_tree(graph));
  EXPECT_TRUE(layers.empty());
  layers.add_first(layout);
  const int first = layout.layer_count();
  EXPECT_GT(first, 0);
  EXPECT_TRUE(layers.add(std::vector<double>{0.5, 0.25}, layout));
  EXPECT_FALSE(layers.add(std::vector<double>{0.25}, layout));
  EXPECT_EQ(layout.layer_count(), first + 2);
  MovingLayout other(graph, any_tree(graph));
  layers.lay(other);
  EXPECT_EQ(other.layer_count(), first + 2);
}

TEST(CertifiedLayers, CertifyWhatFolds) {
  const DualGraph graph = build_dual_graph(cube());
  CertifiedLayers layers(graph, kClearance);
  EXPECT_FALSE(layers.is_decided());
  layers.begin_certificate(any_tree(graph));
  EXPECT_TRUE(layers.is_certifying());
  while (!layers.is_decided()) EXPECT_LE(layers.certify(100), 100);
  EXPECT_EQ(layers.take_counterexamples(), std::nullopt);
  EXPECT_FALSE(layers.is_certifying());
}

TEST(CertifiedLayers, SayWhereFacesMeet) {
  // The first panel of the strip runs through the last one once it is folded.
  const DualGraph graph = build_dual_graph(crossing_strip());
  CertifiedLayers layers(graph, kClearance);
  layers.begin_certificate(any_tree(graph));
  while (!layers.is_decided()) layers.certify(1000000);
  const auto counterexamples = layers.take_counterexamples();
  ASSERT_TRUE(counterexamples);
  EXPECT_FALSE(counterexamples->empty());
}

}  // namespace
}  // namespace foldwright::testing
