#include "repair/t_junctions.h"

#include <gtest/gtest.h>

#include "repair/edge_groups.h"

namespace foldwright {
namespace {

constexpr double kTolerance = 1e-6;

int borders(const TriangleSoup& soup) {
  const EdgeGroups groups = group_half_edges(soup);
  int count = 0;
  for (int g = 0; g < groups.count(); ++g) count += groups.group(g).size() == 1;
  return count;
}

TEST(TJunctions, CutsALongEdgeAtTheShortOnesFacingIt) {
  // One triangle above the edge 0-1, two below it that meet in its middle.
  TriangleSoup soup{{{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, 0, 0}, {1, -1, 0}},
                    {{0, 1, 2}, {3, 0, 4}, {1, 3, 4}},
                    {7, 8, 9}};
  EXPECT_EQ(close_t_junctions(soup, kTolerance).edges, 1);
  EXPECT_EQ(soup.face_count(), 4);
  EXPECT_EQ(soup.source_faces, (std::vector<int>{7, 8, 9, 7}));
  EXPECT_EQ(borders(soup), 4);
  EXPECT_EQ(close_t_junctions(soup, kTolerance).edges, 0);
}

TEST(TJunctions, CutsBothEdgesThatOverlapPartly) {
  // 0-1 and 2-3 overlap between 2 and 1.
  TriangleSoup soup{{{0, 0, 0}, {2, 0, 0}, {1, 0, 0}, {3, 0, 0}, {1, 1, 0}, {2, -1, 0}},
                    {{0, 1, 4}, {3, 2, 5}},
                    {0, 1}};
  EXPECT_EQ(close_t_junctions(soup, kTolerance).edges, 2);
  EXPECT_EQ(borders(soup), 6);
}

TEST(TJunctions, LeavesSheetsThatMerelyTouch) {
  // The second triangle touches the edge 0-1 with its corner 3.
  TriangleSoup soup{{{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, -1, 0}, {2, -1, 0}},
                    {{0, 1, 2}, {3, 4, 5}},
                    {0, 1}};
  EXPECT_EQ(close_t_junctions(soup, kTolerance).edges, 0);
}

TEST(TJunctions, CutsAllThreeEdgesOfAFace) {
  // A triangle surrounded by six that meet in the middles of its edges.
  TriangleSoup soup{{{0, 0, 0},
                     {4, 0, 0},
                     {0, 4, 0},
                     {2, 0, 0},
                     {2, 2, 0},
                     {0, 2, 0},
                     {2, -2, 0},
                     {4, 4, 0},
                     {-2, 2, 0}},
                    {{0, 1, 2}, {3, 0, 6}, {1, 3, 6}, {4, 1, 7}, {2, 4, 7}, {5, 2, 8}, {0, 5, 8}},
                    {0, 1, 2, 3, 4, 5, 6}};
  EXPECT_EQ(close_t_junctions(soup, kTolerance).edges, 3);
  EXPECT_EQ(soup.face_count(), 10);
  EXPECT_EQ(borders(soup), 6);
}

}  // namespace
}  // namespace foldwright
