#include "segment/connect_parts.h"

#include <gtest/gtest.h>

#include <numeric>

#include "drawn_shapes.h"
#include "meshes.h"
#include "parts.h"

namespace foldwright::testing {
namespace {

std::vector<int> own_rows(const DualGraph& graph) {
  std::vector<int> rows(graph.panel_count());
  std::iota(rows.begin(), rows.end(), 0);
  return rows;
}

/// A matrix of ones on the diagonal and the given pairs elsewhere.
FoldabilityMatrix sparse_matrix(int size, const std::vector<std::tuple<int, int, float>>& pairs) {
  FoldabilityMatrix matrix{size, std::vector<float>(static_cast<std::size_t>(size) * size, 0)};
  for (int i = 0; i < size; ++i) matrix.values[i * size + i] = 1;
  for (const auto& [i, j, value] : pairs) {
    matrix.values[i * size + j] = matrix.values[j * size + i] = value;
  }
  return matrix;
}

TEST(ConnectParts, FollowsEquationOneByHand) {
  // A row of panels labelled 0 0 0 1 0 2 2: the fifth is apart from its part, and unfolds with the
  // fourth in 9 of 10 runs, with the last two in 5 of 10 each. Of equal areas part 2 weighs more
  // (0.5 + 0.5 against 0.9); when the fourth panel is twice as large, part 1 (2 * 0.9) does.
  const FoldabilityMatrix matrix = sparse_matrix(7, {{4, 3, 0.9f}, {4, 5, 0.5f}, {4, 6, 0.5f}});
  const Labels labels = {0, 0, 0, 1, 0, 2, 2};
  const auto connected = [&](const std::vector<double>& widths) {
    const DualGraph graph = build_dual_graph(accordion(widths));
    return connect_parts(graph, {matrix, own_rows(graph)}, labels);
  };
  EXPECT_EQ(connected({1, 1, 1, 1, 1, 1, 1}), (Labels{0, 0, 0, 1, 2, 2, 2}));
  EXPECT_EQ(connected({1, 1, 1, 2, 1, 1, 1}), (Labels{0, 0, 0, 1, 1, 2, 2}));
}

TEST(ConnectParts, KeepsTheLargestPieceByArea) {
  const DualGraph graph = build_dual_graph(accordion({1, 1, 1, 5}));
  const FoldabilityMatrix ones{4, std::vector<float>(16, 1)};
  EXPECT_EQ(connect_parts(graph, {ones, own_rows(graph)}, {0, 0, 1, 0}), (Labels{0, 0, 0, 1}));
}

TEST(ConnectParts, LeavesConnectedPartsAlone) {
  const Unfoldable surface = unfoldable(l_prism());
  const FoldabilityMatrix ones{8, std::vector<float>(64, 1)};
  const Labels whole(8, 0);
  EXPECT_EQ(connect_parts(surface.graph, {ones, own_rows(surface.graph)}, whole), whole);
}

TEST(ConnectParts, MakesAnyLabelsConnected) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    for (const Mesh& mesh : {star(), torus(12, 8)}) {
      const DualGraph graph = build_dual_graph(mesh);
      FoldabilityMatrix matrix{graph.panel_count(), {}};
      for (int i = 0; i < matrix.size * matrix.size; ++i) {
        matrix.values.push_back(static_cast<float>(random.uniform()));
      }
      const int parts = 1 + random.below(6);
      Labels labels;
      for (int panel = 0; panel < graph.panel_count(); ++panel) {
        labels.push_back(random.below(parts));
      }
      const int used = part_count(renumbered(labels));
      const Labels connected = connect_parts(graph, {matrix, own_rows(graph)}, labels);
      EXPECT_EQ(fault_of_parts(graph, connected), "");
      EXPECT_EQ(part_count(connected), used) << "a part vanished or split";
    }
  }
}

TEST(ConnectParts, MakesPartsOfComponentsThatTouchNoOther) {
  const DualGraph whole = build_dual_graph(cube());
  const DualGraph graph = restrict_to(whole, std::vector<int>{0, 1});  // opposite sides
  const FoldabilityMatrix ones{2, {1, 1, 1, 1}};
  EXPECT_EQ(connect_parts(graph, {ones, own_rows(graph)}, {0, 0}), (Labels{0, 1}));
}

}  // namespace
}  // namespace foldwright::testing
