#include "search/moving_layout.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "drawn_shapes.h"
#include "meshes.h"
#include "trees.h"

namespace foldwright::testing {
namespace {

using Overlaps = std::vector<std::array<int, 2>>;

Overlaps overlaps_of(const MovingLayout& layout, int panels) {
  Overlaps overlaps;
  for (int a = 0; a < panels; ++a) {
    for (const int b : layout.flat().partners(a)) {
      if (a < b) overlaps.push_back({a, b});
    }
  }
  std::ranges::sort(overlaps);
  return overlaps;
}

/// What differs from laying the same tree out from scratch; empty when nothing does.
std::string fault_of(const MovingLayout& layout, const DualGraph& graph) {
  const int n = graph.panel_count();
  const FoldTree folds = layout.folds();
  if (static_cast<int>(folds.size()) != n - 1) return "not a tree";
  const Overlaps expected = testing::overlaps_of(graph, folds);
  if (overlaps_of(layout, n) != expected) return "other overlaps";
  if (layout.overlap_count() != static_cast<int>(expected.size())) return "wrong count";
  std::vector<int> conflicted(layout.flat().conflicted().begin(), layout.flat().conflicted().end());
  std::ranges::sort(conflicted);
  for (int panel = 0; panel < n; ++panel) {
    if (std::ranges::count(conflicted, panel) != (layout.flat().partners(panel).empty() ? 0 : 1)) {
      return "panel " + std::to_string(panel) + " is listed wrongly";
    }
  }
  return "";
}

/// Panels on the side of `panel` when fold `cut` is taken out of a tree.
std::vector<char> side_of(const DualGraph& graph, const FoldTree& folds, int cut, int panel) {
  std::vector<char> side(graph.panel_count(), 0);
  side[panel] = 1;
  for (bool grew = true; grew;) {
    grew = false;
    for (const int h : folds) {
      const auto& [a, b] = graph.hinges[h].panels;
      if (h == cut || side[a] == side[b]) continue;
      side[a] = side[b] = 1;
      grew = true;
    }
  }
  return side;
}

int crossings(const Overlaps& overlaps, const std::vector<char>& side) {
  return static_cast<int>(std::ranges::count_if(
      overlaps, [&](const auto& pair) { return side[pair[0]] != side[pair[1]]; }));
}

void expect_right_selection(const MovingLayout& layout, const DualGraph& graph, int cut) {
  const FoldTree folds = layout.folds();
  const auto side = side_of(graph, folds, cut, graph.hinges[cut].panels[0]);
  const auto size = static_cast<int>(std::ranges::count(side, 1));
  EXPECT_EQ(layout.selected_size(), std::min(size, graph.panel_count() - size));
  EXPECT_EQ(layout.crossing_conflicts(), crossings(overlaps_of(layout, graph.panel_count()), side));
  std::vector<int> joins(layout.joins().begin(), layout.joins().end());
  std::ranges::sort(joins);
  std::vector<int> expected;
  for (int h = 0; h < graph.hinge_count(); ++h) {
    const auto& [a, b] = graph.hinges[h].panels;
    if (h != cut && side[a] != side[b]) expected.push_back(h);
  }
  EXPECT_EQ(joins, expected);
}

/// Tries a random swap and makes it if it does not bring more than `limit` overlaps.
void swap_randomly(MovingLayout& layout, const DualGraph& graph, Random& random, double limit) {
  const FoldTree folds = layout.folds();
  const int cut = folds[random.below(static_cast<int>(folds.size()))];
  layout.select_side(cut);
  expect_right_selection(layout, graph, cut);
  const auto joins = layout.joins();
  if (joins.empty()) return;
  const int join = joins[random.below(static_cast<int>(joins.size()))];
  const int old = layout.crossing_conflicts();
  const int before = layout.overlap_count();
  const int now = layout.try_join(join, limit);
  if (now > limit) {
    EXPECT_EQ(layout.folds(), folds) << "a refused swap leaves the tree as it is";
    return;
  }
  layout.accept();
  EXPECT_EQ(layout.overlap_count(), before - old + now);
  const FoldTree after = layout.folds();
  EXPECT_FALSE(std::ranges::binary_search(after, cut));
  EXPECT_TRUE(std::ranges::binary_search(after, join));
}

void expect_path(MovingLayout& layout, const DualGraph& graph, Random& random) {
  const int from = random.below(graph.panel_count());
  const int to = random.below(graph.panel_count());
  std::vector<int> path;
  layout.path(from, to, path);
  const FoldTree folds = layout.folds();
  int panel = from;
  for (const int h : path) {
    EXPECT_TRUE(std::ranges::binary_search(folds, h));
    const auto& panels = graph.hinges[h].panels;
    ASSERT_TRUE(panels[0] == panel || panels[1] == panel) << "the path has a gap";
    panel = graph.hinges[h].other(panel);
  }
  EXPECT_EQ(panel, to);
  std::ranges::sort(path);
  EXPECT_EQ(std::ranges::adjacent_find(path), path.end());
}

TEST(MovingLayout, EqualsALayoutFromScratchAfterAnySwaps) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    for (const Mesh& mesh : {random_hull(seed, 40), star(), torus(8, 6), l_prism(), saddle(8, 7)}) {
      const DualGraph graph = build_dual_graph(mesh);
      SCOPED_TRACE(graph.panel_count());
      MovingLayout layout(graph, random_tree(graph, random));
      ASSERT_EQ(fault_of(layout, graph), "");
      for (int swap = 0; swap < 300; ++swap) {
        // Some are always made, some hardly ever.
        const double limit =
            swap % 3 == 0 ? std::numeric_limits<double>::infinity() : random.below(4);
        swap_randomly(layout, graph, random, limit);
        expect_path(layout, graph, random);
        ASSERT_EQ(fault_of(layout, graph), "") << "after swap " << swap;
      }
      const FoldTree folds = layout.folds();
      layout.refresh();
      EXPECT_EQ(layout.folds(), folds);
      EXPECT_EQ(fault_of(layout, graph), "");
    }
  }
}

constexpr std::array<double, 3> kShares = {0.4, 0.8, 1};

/// Overlaps in the plane and collisions at each of `kShares`, looked for from scratch.
Overlaps conflicts_of(const Foldable& foldable, const FoldTree& folds) {
  const DualGraph& graph = *foldable.graph;
  Overlaps all = testing::overlaps_of(graph, folds);
  const RootedTree tree = hang_tree(graph, folds);
  for (const double share : kShares) {
    const auto layout = fold_up(foldable, tree, fold_angles(graph, share));
    std::ranges::copy(colliding_panels(foldable, tree, layout), std::back_inserter(all));
  }
  std::ranges::sort(all);
  return all;
}

TEST(MovingLayout, KeepsCollisionsInSpaceUpToDate) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    for (const Mesh& mesh : {random_hull(seed, 30), bumpy_sphere(80), torus(7, 5), l_prism()}) {
      const DualGraph graph = build_dual_graph(mesh);
      SCOPED_TRACE(graph.panel_count());
      const Foldable foldable = make_foldable(graph);
      MovingLayout layout(graph, random_tree(graph, random));
      for (const double share : kShares) layout.add_layer(foldable, share);
      EXPECT_EQ(layout.layer_count(), 3);
      for (int swap = 0; swap < 150; ++swap) {
        const FoldTree folds = layout.folds();
        layout.select_side(folds[random.below(static_cast<int>(folds.size()))]);
        const auto joins = layout.joins();
        if (joins.empty()) continue;
        const int join = joins[random.below(static_cast<int>(joins.size()))];
        const int old = layout.crossing_conflicts();
        const int before = layout.conflict_count();
        const double limit = swap % 2 == 0 ? std::numeric_limits<double>::infinity() : old;
        const int now = layout.try_join(join, limit);
        if (now > limit) continue;
        layout.accept();
        ASSERT_EQ(layout.conflict_count(), before - old + now);
        Overlaps conflicts = layout.conflicts();
        std::ranges::sort(conflicts);
        ASSERT_EQ(conflicts, conflicts_of(foldable, layout.folds())) << "after swap " << swap;
        EXPECT_EQ(layout.overlap_count() + layout.collision_count(), layout.conflict_count());
        if (conflicts.empty()) continue;
        auto pair = layout.random_conflict(random);
        std::ranges::sort(pair);
        EXPECT_TRUE(std::ranges::binary_search(conflicts, pair));
      }
      layout.refresh();
      Overlaps conflicts = layout.conflicts();
      std::ranges::sort(conflicts);
      EXPECT_EQ(conflicts, conflicts_of(foldable, layout.folds()));
    }
  }
}

TEST(MovingLayout, StopsCountingAboveTheLimit) {
  const DualGraph graph = build_dual_graph(star());
  Random random(1);
  MovingLayout layout(graph, random_tree(graph, random));
  for (int i = 0; i < 200; ++i) {
    const FoldTree folds = layout.folds();
    layout.select_side(folds[random.below(static_cast<int>(folds.size()))]);
    if (layout.joins().empty()) continue;
    const int join = layout.joins()[0];
    const int all = layout.try_join(join, std::numeric_limits<double>::infinity());
    for (const int limit : {0, 1, 5}) {
      const int counted = layout.try_join(join, limit);
      EXPECT_EQ(counted > limit, all > limit);
      EXPECT_LE(counted, limit + 1);
    }
  }
}

}  // namespace
}  // namespace foldwright::testing
