#include "fold/waypoint_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "folding.h"
#include "meshes.h"
#include "trees.h"

namespace foldwright::testing {
namespace {

using State = WaypointSearch::State;

constexpr std::int64_t kToTheEnd = std::numeric_limits<std::int64_t>::max();

/// A model and a net of it that does not fold straight.
struct Crooked {
  Mesh mesh;
  DualGraph graph;
  FoldTree folds;
  Foldable foldable;

  explicit Crooked(Mesh of)
      : mesh(std::move(of)),
        graph(build_dual_graph(mesh)),
        folds(net_that_does_not_fold_straight(mesh, graph, 10)),
        foldable(make_foldable(graph)) {}
};

void expect_binary_keys(const std::vector<std::vector<double>>& keys, int legs,
                        std::size_t fold_count) {
  ASSERT_EQ(static_cast<int>(keys.size()), legs + 1);
  EXPECT_EQ(keys.front(), std::vector<double>(fold_count, 0));
  EXPECT_EQ(keys.back(), std::vector<double>(fold_count, 1));
  for (std::size_t key = 1; key < keys.size(); ++key) {
    ASSERT_EQ(keys[key].size(), fold_count);
    for (std::size_t fold = 0; fold < fold_count; ++fold) {
      EXPECT_TRUE(keys[key][fold] == 0 || keys[key][fold] == 1);
      EXPECT_GE(keys[key][fold], keys[key - 1][fold]) << "a fold turned back";
    }
  }
}

TEST(WaypointSearch, FoldsNetsThatDoNotFoldStraight) {
  for (const Mesh& mesh : {bumpy_sphere(80), bumpy_sphere(130), dumbbell()}) {
    SCOPED_TRACE(mesh.face_count());
    const Crooked net(mesh);
    ASSERT_FALSE(net.folds.empty());
    for (const int legs : {2, 3}) {
      SCOPED_TRACE(legs);
      WaypointSearch search(net.foldable, net.folds, legs, 1);
      ASSERT_EQ(search.step(kToTheEnd), State::kFound);
      expect_binary_keys(search.keys(), legs, net.folds.size());
      const PlainFolder folder(net.mesh, net.graph, net.folds);
      const FoldMotion motion = motion_over(search.keys());
      EXPECT_TRUE(colliding_times(folder, net.graph, net.folds, motion, 1000).empty());
    }
  }
}

TEST(WaypointSearch, DoesNotDependOnTheSlicing) {
  const Crooked net(bumpy_sphere(80));
  const auto run = [&](std::int64_t slice, std::uint64_t seed) {
    WaypointSearch search(net.foldable, net.folds, 2, seed);
    while (search.step(slice) == State::kRunning) continue;
    EXPECT_EQ(search.step(slice), search.state());
    return std::pair(search.state(), search.keys());
  };
  for (const std::uint64_t seed : {1, 2}) {
    const auto at_once = run(kToTheEnd, seed);
    for (const std::int64_t slice : {1, 333, 100000}) EXPECT_EQ(run(slice, seed), at_once);
  }
}

TEST(WaypointSearch, GivesUpWhereTheFlatNetOverlaps) {
  const Mesh mesh = star();
  const DualGraph graph = build_dual_graph(mesh);
  Random random(1);
  const FoldTree folds = random_tree(graph, random);
  ASSERT_FALSE(overlaps_of(graph, folds).empty());
  const Foldable foldable = make_foldable(graph);
  WaypointSearch search(foldable, folds, 2, 1);
  EXPECT_EQ(search.step(kToTheEnd), State::kGaveUp);
  EXPECT_EQ(search.step(1000), State::kGaveUp);
}

TEST(WaypointSearch, SolvesAtOnceWhatFoldsAnyhow) {
  const Mesh mesh = cube();
  const DualGraph graph = build_dual_graph(mesh);
  const Foldable foldable = make_foldable(graph);
  const FoldTree folds = searched_net(mesh, graph, 1, kClearance);
  for (const int legs : {2, 3, 4}) {
    WaypointSearch search(foldable, folds, legs, 1);
    ASSERT_EQ(search.step(kToTheEnd), State::kFound);
    expect_binary_keys(search.keys(), legs, folds.size());
  }
}

}  // namespace
}  // namespace foldwright::testing
