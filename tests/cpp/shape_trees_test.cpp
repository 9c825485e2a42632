#include "fold/shape_trees.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "folding.h"
#include "meshes.h"
#include "trees.h"

namespace foldwright::testing {
namespace {

using State = ShapeTrees::State;

constexpr std::int64_t kToTheEnd = std::numeric_limits<std::int64_t>::max();

void expect_good_motion(const Mesh& mesh, const DualGraph& graph, const FoldTree& folds,
                        const ShapeTrees& search) {
  const auto& keys = search.keys();
  ASSERT_GE(keys.size(), 2u);
  EXPECT_EQ(keys.front(), std::vector<double>(folds.size(), 0));
  EXPECT_EQ(keys.back(), std::vector<double>(folds.size(), 1));
  for (const auto& key : keys) {
    ASSERT_EQ(key.size(), folds.size());
    for (const double share : key) {
      EXPECT_GE(share, 0);
      EXPECT_LE(share, 1);
    }
  }
  const PlainFolder folder(mesh, graph, folds);
  EXPECT_TRUE(colliding_times(folder, graph, folds, motion_over(keys), 1000).empty());
}

/// A base of width 1 with two arms over it, the left one low and the right one above it.
Mesh crossed_arms() {
  constexpr double kWidth = 0.8;
  constexpr double kLow = 0.05;
  constexpr double kHigh = 0.52;
  const std::vector<Vec2> section = {
      kWidth * Vec2(std::cos(kLow), std::sin(kLow)),
      {0, 0},
      {1, 0},
      Vec2(1, 0) + kWidth * Vec2(-std::cos(kHigh), std::sin(kHigh)),
  };
  std::vector<Vec3> positions;
  for (const Vec2& p : section) {
    positions.emplace_back(p.x(), 0, p.y());
    positions.emplace_back(p.x(), 1, p.y());
  }
  std::vector<std::array<int, 3>> faces;
  for (int i = 0; i < 3; ++i) {
    const int a = 2 * i;
    faces.insert(faces.end(), {{a, a + 2, a + 3}, {a, a + 3, a + 1}});
  }
  return make_mesh(std::move(positions), std::move(faces));
}

TEST(ShapeTrees, FoldsASmallNetThatDoesNotFoldStraight) {
  const Mesh mesh = crossed_arms();
  const DualGraph graph = build_dual_graph(mesh);
  const Foldable foldable = make_foldable(graph);
  const FoldTree folds = {0, 1};
  Certificate straight(foldable, folds, straight_leg(graph));
  ASSERT_EQ(straight.step(kToTheEnd), Certificate::State::kRefuted);
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE(seed);
    ShapeTrees search(foldable, folds, seed);
    ASSERT_EQ(search.step(kToTheEnd), State::kFound);
    expect_good_motion(mesh, graph, folds, search);
  }
}

TEST(ShapeTrees, FoldsWhatFoldsAnyhow) {
  for (const Mesh& mesh : {cube(), tetrahedron(), icosahedron()}) {
    const DualGraph graph = build_dual_graph(mesh);
    const Foldable foldable = make_foldable(graph);
    const FoldTree folds = searched_net(mesh, graph, 1, kClearance);
    ShapeTrees search(foldable, folds, 7);
    ASSERT_EQ(search.step(kToTheEnd), State::kFound);
    expect_good_motion(mesh, graph, folds, search);
  }
}

TEST(ShapeTrees, DoesNotDependOnTheSlicing) {
  const Mesh mesh = crossed_arms();
  const DualGraph graph = build_dual_graph(mesh);
  const Foldable foldable = make_foldable(graph);
  const FoldTree folds = {0, 1};
  const auto run = [&](std::int64_t slice) {
    ShapeTrees search(foldable, folds, 5);
    while (search.step(slice) == State::kRunning) continue;
    EXPECT_EQ(search.step(slice), search.state());
    return std::pair(search.state(), search.keys());
  };
  const auto at_once = run(kToTheEnd);
  for (const std::int64_t slice : {1, 333, 100000}) EXPECT_EQ(run(slice), at_once);
}

/// A base of width 1 with an arm at either end, folded by these angles.
DualGraph folded_arms(double width, double left, double right) {
  DualGraph strip = build_dual_graph(accordion({width, 1, width}));
  strip.hinges[0].angle = left;
  strip.hinges[1].angle = right;
  return strip;
}

TEST(ShapeTrees, GivesUpWhereTheModelMeetsItself) {
  const double angle = 0.75 * std::numbers::pi;
  const DualGraph graph = folded_arms(1, angle, angle);
  const Foldable foldable = make_foldable(graph);
  const FoldTree folds = {0, 1};
  ASSERT_TRUE(meets_itself(foldable));
  ShapeTrees search(foldable, folds, 1);
  EXPECT_EQ(search.step(kToTheEnd), State::kGaveUp);
  EXPECT_EQ(search.step(1000), State::kGaveUp);
}

TEST(ShapeTrees, GivesUpWhereTheEndCannotBeReached) {
  // An arm that is longer than the base and lies beyond it, past the hinge of the other arm.
  const DualGraph graph = folded_arms(1.5, std::numbers::pi + 0.3, 0.5 * std::numbers::pi);
  const Foldable foldable = make_foldable(graph);
  const FoldTree folds = {0, 1};
  ASSERT_FALSE(meets_itself(foldable));
  ShapeTrees search(foldable, folds, 1);
  EXPECT_EQ(search.step(kToTheEnd), State::kGaveUp);
}

}  // namespace
}  // namespace foldwright::testing
