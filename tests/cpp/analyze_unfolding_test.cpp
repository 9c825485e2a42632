#include "segment/analyze_unfolding.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "meshes.h"
#include "trees.h"

namespace foldwright::testing {
namespace {

using Overlaps = std::vector<std::array<int, 2>>;

/// A random tree over panels 0 to n - 1, hung from panel 0; `bushy` in (0, 1] makes it so.
RootedTree random_rooted_tree(Random& random, int n, double bushy) {
  // Panels get shuffled numbers, so that the lower panel is not always nearer to the root.
  std::vector<int> number(n);
  for (int i = 0; i < n; ++i) number[i] = i;
  for (int i = n - 1; i > 0; --i) std::swap(number[i], number[random.below(i + 1)]);
  std::vector<std::vector<int>> neighbours(n);
  for (int i = 1; i < n; ++i) {
    const int reach = std::max(1, static_cast<int>(bushy * i));
    const int before = number[i - 1 - random.below(reach)];
    neighbours[before].push_back(number[i]);
    neighbours[number[i]].push_back(before);
  }
  RootedTree tree{{0}, std::vector<int>(n, -1), std::vector<int>(n, -1)};
  for (std::size_t head = 0; head < tree.order.size(); ++head) {
    for (const int next : neighbours[tree.order[head]]) {
      if (next == tree.parent[tree.order[head]]) continue;
      tree.parent[next] = tree.order[head];
      tree.order.push_back(next);
    }
  }
  return tree;
}

Overlaps random_overlaps(Random& random, int n, int count) {
  std::set<std::array<int, 2>> pairs;
  for (int i = 0; i < count; ++i) {
    const int a = random.below(n);
    const int b = random.below(n);
    if (a != b) pairs.insert({std::min(a, b), std::max(a, b)});
  }
  return {pairs.begin(), pairs.end()};
}

/// Members of the component of one source as the paper defines it: breadth first over the folds,
/// distance by distance and within one from the lowest panel, adding what overlaps no member.
std::vector<char> component_of(int source, const RootedTree& tree, const Overlaps& overlaps) {
  const int n = static_cast<int>(tree.parent.size());
  std::vector<std::vector<int>> neighbours(n), partners(n);
  for (int panel = 0; panel < n; ++panel) {
    if (tree.parent[panel] == -1) continue;
    neighbours[panel].push_back(tree.parent[panel]);
    neighbours[tree.parent[panel]].push_back(panel);
  }
  for (const auto& [a, b] : overlaps) {
    partners[a].push_back(b);
    partners[b].push_back(a);
  }
  std::vector<char> member(n, 0), seen(n, 0);
  member[source] = seen[source] = 1;
  for (std::vector<int> level = {source}; !level.empty();) {
    std::set<int> next;
    for (const int panel : level) {
      for (const int neighbour : neighbours[panel]) {
        if (!seen[neighbour]) next.insert(neighbour);
      }
    }
    level.clear();
    for (const int panel : next) {
      seen[panel] = 1;
      const bool blocked = std::ranges::any_of(partners[panel], [&](int p) { return member[p]; });
      if (blocked) continue;
      member[panel] = 1;
      level.push_back(panel);
    }
  }
  return member;
}

void expect_reference(const RootedTree& tree, const Overlaps& overlaps) {
  const int n = static_cast<int>(tree.parent.size());
  UnfoldingAnalysis analysis(tree, overlaps);
  std::vector<SourceMask> members;
  for (int first = 0; first < n; first += kSourceBlock) {
    analysis.components_of(first, members);
    for (int i = 0; i < kSourceBlock; ++i) {
      const bool exists = first + i < n;
      const std::vector<char> expected =
          exists ? component_of(first + i, tree, overlaps) : std::vector<char>(n, 0);
      for (int panel = 0; panel < n; ++panel) {
        const bool is_member = (members[panel][i / 64] >> (i % 64) & 1) != 0;
        ASSERT_EQ(is_member, expected[panel] != 0) << "panel " << panel << " of " << first + i;
      }
    }
  }
}

TEST(UnfoldingAnalysis, AgreesWithBreadthFirstSearchOnRandomTrees) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const int n = 1 + random.below(60);
    const RootedTree tree = random_rooted_tree(random, n, random.uniform());
    expect_reference(tree, random_overlaps(random, n, random.below(3 * n)));
  }
}

TEST(UnfoldingAnalysis, AgreesOverSeveralBlocksOfSources) {
  for (const int n : {kSourceBlock, kSourceBlock + 1, 3 * kSourceBlock - 70}) {
    SCOPED_TRACE(n);
    Random random(static_cast<std::uint64_t>(n));
    for (const double bushy : {0.02, 1.0}) {
      expect_reference(random_rooted_tree(random, n, bushy), random_overlaps(random, n, n / 2));
    }
  }
}

TEST(UnfoldingAnalysis, AgreesOnUnfoldedMeshes) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    for (const Mesh& mesh : {random_hull(seed, 60), star(), torus(8, 6), dumbbell()}) {
      const DualGraph graph = build_dual_graph(mesh);
      const FoldTree folds = random_tree(graph, random);
      expect_reference(hang_tree(graph, folds), overlaps_of(graph, folds));
    }
  }
}

TEST(UnfoldingAnalysis, TakesTheLowerPanelFirstAtEqualDistance) {
  // A star of three arms: panels 1 and 2 are equally far from 0 and 3, and overlap.
  const RootedTree tree{{0, 1, 2, 3}, {-1, 0, 0, 0}, {-1, 0, 1, 2}};
  const Overlaps overlaps = {{1, 2}};
  EXPECT_EQ(component_of(0, tree, overlaps), (std::vector<char>{1, 1, 0, 1}));
  EXPECT_EQ(component_of(2, tree, overlaps), (std::vector<char>{1, 0, 1, 1}));
  EXPECT_EQ(component_of(3, tree, overlaps), (std::vector<char>{1, 1, 0, 1}));
  expect_reference(tree, overlaps);
}

}  // namespace
}  // namespace foldwright::testing
