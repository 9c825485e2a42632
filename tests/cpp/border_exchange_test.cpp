#include "search/border_exchange.h"

#include <gtest/gtest.h>

#include <limits>

#include "folding.h"
#include "meshes.h"
#include "parts.h"
#include "trees.h"

namespace foldwright::testing {
namespace {

using State = BorderExchange::State;

constexpr std::int64_t kToTheEnd = std::numeric_limits<std::int64_t>::max();

/// The fan as part 0 and the apron as part 1.
struct Apron {
  Mesh mesh;
  DualGraph graph;
  Labels labels;

  Apron(double turn, int quads)
      : mesh(saddle_with_apron(turn, quads)), graph(build_dual_graph(mesh)) {
    for (int panel = 0; panel < graph.panel_count(); ++panel) {
      labels.push_back(graph.panel_faces(panel)[0] < 8 ? 0 : 1);
    }
  }

  PartsSoFar parts() const { return {labels, {}, {{0, 1}}}; }
};

TEST(BorderExchange, CuresAPartWithoutANet) {
  const Apron apron(7, 3);  // 401 degrees
  const DualGraph fan = restrict_to(apron.graph, panels_of(apron.labels, 0));
  for (const FoldTree& folds : all_spanning_trees(fan)) {
    ASSERT_FALSE(is_net(apron.mesh, fan, folds)) << "there is nothing to cure";
  }
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE(seed);
    BorderExchange exchange(apron.mesh, apron.graph, apron.parts(), {.seed = seed});
    ASSERT_EQ(exchange.step(kToTheEnd), State::kFound);
    EXPECT_EQ(exchange.shortfall(), 0);
    EXPECT_EQ(fault_of_parts(apron.graph, exchange.labels()), "");
    EXPECT_EQ(part_count(exchange.labels()), 2);
    for (const int part : {0, 1}) {
      const DualGraph graph = restrict_to(apron.graph, panels_of(exchange.labels(), part));
      ASSERT_TRUE(exchange.trees().contains(part));
      EXPECT_TRUE(is_net(apron.mesh, graph, exchange.trees().at(part)));
    }
  }
}

TEST(BorderExchange, GivesBothPartsNetsThatFold) {
  const Apron apron(7, 3);  // 401 degrees
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE(seed);
    BorderExchange exchange(apron.mesh, apron.graph, apron.parts(),
                            {.clearance = kClearance, .seed = seed});
    ASSERT_EQ(exchange.step(kToTheEnd), State::kFound);
    EXPECT_EQ(fault_of_parts(apron.graph, exchange.labels()), "");
    EXPECT_TRUE(exchange.shortfalls().empty());
    for (const int part : {0, 1}) {
      const DualGraph graph = restrict_to(apron.graph, panels_of(exchange.labels(), part));
      const FoldTree& folds = exchange.trees().at(part);
      EXPECT_TRUE(is_net(apron.mesh, graph, folds));
      const Foldable foldable = make_foldable(graph);
      Certificate certificate(foldable, folds, straight_leg(graph));
      EXPECT_EQ(certificate.step(kToTheEnd), Certificate::State::kCertified);
      const PlainFolder folder(apron.mesh, graph, folds);
      EXPECT_TRUE(
          colliding_times(folder, fold_angles(graph, 0), fold_angles(graph, 1), 1000).empty());
    }
  }
}

TEST(BorderExchange, ForgetsWhatANeighbourLackedOnceItHasIt) {
  // The apron is said to lack something, but any tree of its strip is a net.
  const Apron apron(7, 3);
  PartsSoFar parts = apron.parts();
  parts.shortfalls[1] = 2;
  BorderExchange exchange(apron.mesh, apron.graph, parts, {.seed = 1});
  ASSERT_EQ(exchange.step(kToTheEnd), State::kFound);
  EXPECT_TRUE(exchange.shortfalls().empty());
}

TEST(BorderExchange, KeepsPartsConnectedAllTheWay) {
  const Apron apron(7, 3);  // 401 degrees
  BorderExchange exchange(apron.mesh, apron.graph, apron.parts(), {.seed = 1});
  while (exchange.step(1) == State::kRunning) {
    ASSERT_EQ(fault_of_parts(apron.graph, exchange.labels()), "");
    ASSERT_EQ(part_count(exchange.labels()), 2);
    EXPECT_GE(exchange.progress(), 0);
    EXPECT_LE(exchange.progress(), 1);
  }
}

TEST(BorderExchange, DoesNotDependOnTheSlicing) {
  const Apron apron(7, 3);  // 401 degrees
  const auto run = [&](std::int64_t slice) {
    BorderExchange exchange(apron.mesh, apron.graph, apron.parts(), {.seed = 3});
    while (exchange.step(slice) == State::kRunning) continue;
    return std::tuple(exchange.labels(), exchange.trees(), exchange.moves());
  };
  const auto at_once = run(kToTheEnd);
  for (const std::int64_t slice : {1, 100, 3000}) EXPECT_EQ(run(slice), at_once);
}

TEST(BorderExchange, GivesUpWithoutANeighbour) {
  const Mesh mesh = saddle(8, 7);
  const DualGraph graph = build_dual_graph(mesh);
  BorderExchange exchange(mesh, graph, {Labels(8, 0), {}, {{0, 1}}});
  EXPECT_EQ(exchange.step(kToTheEnd), State::kGaveUp);
  EXPECT_EQ(exchange.labels(), Labels(8, 0));
  EXPECT_GT(exchange.shortfall(), 0);
}

TEST(BorderExchange, KeepsPartsConnectedWhenItGivesUp) {
  // Of 600 degrees at least 375 are left after three exchanges.
  const Apron apron(10.5, 1);
  BorderExchange exchange(apron.mesh, apron.graph, apron.parts(), {.most_steps = 3});
  EXPECT_EQ(exchange.step(kToTheEnd), State::kGaveUp);
  EXPECT_EQ(fault_of_parts(apron.graph, exchange.labels()), "");
  EXPECT_EQ(part_count(exchange.labels()), 2);
}

}  // namespace
}  // namespace foldwright::testing
