#include "segment/foldability.h"

#include <gtest/gtest.h>

#include <numbers>
#include <numeric>

#include "meshes.h"
#include "parts.h"

namespace foldwright::testing {
namespace {

FoldabilityCounts counts_of(const Unfoldable& surface, const LearnOptions& options, int first,
                            int last) {
  FoldabilityLearner learner(surface.mesh, surface.graph, options, {first, last});
  while (learner.step()) continue;
  EXPECT_EQ(learner.runs_done(), last - first);
  return learner.counts();
}

FoldabilityMatrix learn(const Unfoldable& surface, const LearnOptions& options) {
  return to_matrix(counts_of(surface, options, 0, options.runs));
}

TEST(Foldability, OfAFourFoldSaddleByHand) {
  // Four panels of 100 degrees around a vertex. An unfolding cuts one of the four hinges and lays
  // the panels in a row a, b, c, d, of which just a and d overlap. Breadth first from a, the row is
  // taken up to c, since d then overlaps a; likewise from d down to b. From b, panel a comes before
  // d, and from c, d before a. So of the pairs of neighbours in the row all unfold together; of a
  // and c, and of b and d, c is in a's component but a is not in c's: 1/2; a and d never do.
  const Unfoldable surface = unfoldable(saddle(4, 400 * std::numbers::pi / 180));
  const auto across = [&](const FoldabilityMatrix& m, int h) {
    return m(surface.graph.hinges[h].panels[0], surface.graph.hinges[h].panels[1]);
  };
  for (const Heuristic heuristic :
       {Heuristic::kSteepestEdge, Heuristic::kFlatTree, Heuristic::kHybrid, Heuristic::kRandom}) {
    const FoldabilityMatrix one = learn(surface, {.heuristic = heuristic, .runs = 1});
    const FoldabilityMatrix many = learn(surface, {.heuristic = heuristic, .runs = 64});
    EXPECT_EQ(one(0, 2), 0.5f);
    EXPECT_EQ(one(1, 3), 0.5f);
    EXPECT_EQ(many(0, 2), 0.5f);
    EXPECT_EQ(many(1, 3), 0.5f);
    int cut = 0;
    float sum = 0;
    for (int h = 0; h < 4; ++h) {
      EXPECT_TRUE(across(one, h) == 0 || across(one, h) == 1);
      cut += across(one, h) == 0;
      sum += across(many, h);  // one minus the share of runs that cut the hinge
    }
    EXPECT_EQ(cut, 1);
    EXPECT_FLOAT_EQ(sum, 3);
  }
}

TEST(Foldability, IsOneWhereEveryUnfoldingIsANet) {
  for (const Mesh& mesh : {tetrahedron(), cube(), accordion({1, 2, 3, 1})}) {
    const FoldabilityMatrix matrix =
        learn(unfoldable(mesh), {.heuristic = Heuristic::kRandom, .runs = 50});
    for (const float value : matrix.values) EXPECT_EQ(value, 1);
  }
}

TEST(Foldability, IsSymmetricWithOnesOnTheDiagonal) {
  const Unfoldable surface = unfoldable(dumbbell());
  for (const DirectionSet directions : {DirectionSet::kRandom, DirectionSet::kFaceNormals,
                                        DirectionSet::kVertexNormals, DirectionSet::kEdges}) {
    const FoldabilityMatrix matrix = learn(surface, {.directions = directions, .runs = 30});
    ASSERT_EQ(matrix.size, surface.graph.panel_count());
    float least = 1;
    for (int i = 0; i < matrix.size; ++i) {
      EXPECT_EQ(matrix(i, i), 1);
      for (int j = 0; j < i; ++j) {
        EXPECT_EQ(matrix(i, j), matrix(j, i));
        EXPECT_GE(matrix(i, j), 0);
        EXPECT_LE(matrix(i, j), 1);
        least = std::min(least, matrix(i, j));
      }
    }
    EXPECT_LT(least, 0.9f);
  }
}

TEST(Foldability, CountsOfSeveralLearnersAddUp) {
  // More panels than one block of sources, and runs that do not fill a power of two.
  const Unfoldable surface = unfoldable(random_hull(3, 150));
  ASSERT_GT(surface.graph.panel_count(), kSourceBlock);
  const LearnOptions options = {.heuristic = Heuristic::kHybrid, .runs = 37, .seed = 5};
  const FoldabilityCounts whole = counts_of(surface, options, 0, 37);
  FoldabilityCounts sum;
  for (const auto& [first, last] : {std::pair(0, 1), std::pair(1, 16), std::pair(16, 37)}) {
    sum.add(counts_of(surface, options, first, last));
  }
  EXPECT_EQ(sum.runs, 37);
  EXPECT_EQ(sum.counts, whole.counts);
  EXPECT_NE(
      counts_of(surface, {.heuristic = Heuristic::kHybrid, .runs = 37, .seed = 6}, 0, 37).counts,
      whole.counts);
}

TEST(Foldability, OfSomePanelsIsTheirRowsAndColumns) {
  FoldabilityMatrix matrix{3, {1, 0.1f, 0.2f, 0.1f, 1, 0.3f, 0.2f, 0.3f, 1}};
  const FoldabilityMatrix part = restrict_to(matrix, std::vector<int>{2, 0});
  EXPECT_EQ(part.size, 2);
  EXPECT_EQ(part.values, (std::vector<float>{1, 0.2f, 0.2f, 1}));
  const std::vector<int> rows = {1, 1, 0};
  const CarriedFoldability carried{matrix, rows};
  EXPECT_EQ(carried(0, 1), 1);
  EXPECT_EQ(carried(1, 2), 0.1f);
}

}  // namespace
}  // namespace foldwright::testing
