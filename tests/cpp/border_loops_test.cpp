#include "repair/border_loops.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "repair/edge_groups.h"

namespace foldwright::testing {
namespace {

/// Triangles of the plane, by their corners alone.
TriangleSoup sheet(int vertices, std::vector<std::array<int, 3>> faces) {
  TriangleSoup soup;
  for (int v = 0; v < vertices; ++v) soup.positions.emplace_back(v, v * v, 0);
  soup.source_faces.assign(faces.size(), 0);
  soup.faces = std::move(faces);
  return soup;
}

TEST(BorderLoops, RunAgainstTheFacesBesideThem) {
  const std::vector<BorderLoop> loops = find_border_loops(sheet(4, {{0, 1, 2}, {0, 2, 3}}));
  ASSERT_EQ(loops.size(), 1u);
  EXPECT_EQ(loops[0].vertices, (std::vector<int>{0, 3, 2, 1}));
  EXPECT_EQ(loops[0].half_edges, (std::vector<int>{5, 4, 1, 0}));
}

TEST(BorderLoops, RunAgainstMostFacesWhereTheyDisagree) {
  const auto loops = find_border_loops(sheet(5, {{0, 1, 2}, {0, 2, 3}, {0, 4, 3}}));
  ASSERT_EQ(loops.size(), 1u);
  EXPECT_EQ(loops[0].vertices, (std::vector<int>{0, 4, 3, 2, 1}));
}

TEST(BorderLoops, AreToldApartWhereTheyTouch) {
  // Two sheets of two triangles that share vertex 0.
  const TriangleSoup soup = sheet(7, {{0, 1, 2}, {0, 2, 3}, {0, 4, 5}, {0, 5, 6}});
  const std::vector<BorderLoop> loops = find_border_loops(soup);
  ASSERT_EQ(loops.size(), 2u);
  for (const BorderLoop& loop : loops) {
    ASSERT_EQ(loop.vertices.size(), 4u);
    EXPECT_EQ(std::ranges::count(loop.vertices, 0), 1);
    for (int i = 0; i < 4; ++i) {
      EXPECT_EQ(end_vertex(soup, loop.half_edges[i]), loop.vertices[i]);
      EXPECT_EQ(start_vertex(soup, loop.half_edges[i]), loop.vertices[(i + 1) % 4]);
    }
  }
}

TEST(BorderLoops, AreNotMadeOfEdgesThatLeadNowhere) {
  // A tetrahedron with a fin at its edge from 0 to 1.
  EXPECT_TRUE(
      find_border_loops(sheet(5, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {0, 1, 4}})).empty());
}

}  // namespace
}  // namespace foldwright::testing
