#include "fold/planner.h"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

#include "drawn_shapes.h"
#include "folding.h"
#include "meshes.h"
#include "trees.h"

namespace foldwright::testing {
namespace {

constexpr std::int64_t kToTheEnd = std::numeric_limits<std::int64_t>::max();

FoldMotion plan(const Foldable& foldable, const FoldTree& folds, std::uint64_t seed = 1,
                std::int64_t slice = kToTheEnd) {
  MotionPlanner planner(foldable, folds, seed);
  double progress = 0;
  while (!planner.step(slice)) {
    EXPECT_GE(planner.progress(), progress);
    EXPECT_LE(planner.progress(), 1);
    progress = planner.progress();
  }
  EXPECT_TRUE(planner.step(slice));
  return planner.motion();
}

bool are_equal(const FoldMotion& a, const FoldMotion& b) {
  return a.kind == b.kind && a.times == b.times && a.shares == b.shares;
}

TEST(MotionPlanner, FoldsStraightWhatDoes) {
  for (const Mesh& mesh : {cube(), icosahedron(), l_prism(), bumpy_sphere(80)}) {
    SCOPED_TRACE(mesh.face_count());
    const DualGraph graph = build_dual_graph(mesh);
    const FoldTree folds = searched_net(mesh, graph, 1, kClearance);
    const FoldMotion motion = plan(make_foldable(graph), folds);
    EXPECT_EQ(motion.kind, Folding::kLine);
    EXPECT_EQ(motion.shares, straight_motion(folds).shares);
  }
}

TEST(MotionPlanner, FindsAWayForNetsThatDoNotFoldStraight) {
  for (const Mesh& mesh : {star(), bumpy_sphere(80), bumpy_sphere(130)}) {
    SCOPED_TRACE(mesh.face_count());
    const DualGraph graph = build_dual_graph(mesh);
    const Foldable foldable = make_foldable(graph);
    const FoldTree folds = net_that_does_not_fold_straight(mesh, graph, 10);
    ASSERT_FALSE(folds.empty());
    const FoldMotion motion = plan(foldable, folds);
    ASSERT_EQ(motion.kind, Folding::kWaypoints);
    EXPECT_EQ(motion.shares.front(), std::vector<double>(folds.size(), 0));
    EXPECT_EQ(motion.shares.back(), std::vector<double>(folds.size(), 1));
    const PlainFolder folder(mesh, graph, folds);
    EXPECT_TRUE(colliding_times(folder, graph, folds, motion, 1000).empty());
  }
}

TEST(MotionPlanner, GivesTheSameFromTheSameSeedInAnySlices) {
  const Mesh mesh = bumpy_sphere(80);
  const DualGraph graph = build_dual_graph(mesh);
  const Foldable foldable = make_foldable(graph);
  const FoldTree folds = net_that_does_not_fold_straight(mesh, graph, 10);
  ASSERT_FALSE(folds.empty());
  const FoldMotion motion = plan(foldable, folds, 3);
  for (const std::int64_t slice : {50, 5000, 1000000}) {
    EXPECT_TRUE(are_equal(plan(foldable, folds, 3, slice), motion));
  }
}

TEST(MotionPlanner, SaysWhenThereIsNoMotion) {
  DualGraph strip = build_dual_graph(accordion({1, 1, 1}));
  for (Hinge& hinge : strip.hinges) hinge.angle = 0.75 * std::numbers::pi;
  const Foldable foldable = make_foldable(strip);
  ASSERT_TRUE(meets_itself(foldable));
  const FoldMotion motion = plan(foldable, {0, 1});
  EXPECT_EQ(motion.kind, Folding::kNone);
  EXPECT_TRUE(motion.times.empty());
}

TEST(MotionPlanner, OfOnePanelIsDoneAtOnce) {
  const DualGraph graph = build_dual_graph(open_strip(2));
  EXPECT_EQ(plan(make_foldable(graph), {}).kind, Folding::kLine);
}

}  // namespace
}  // namespace foldwright::testing
