#include "repair/close_cracks.h"

#include <gtest/gtest.h>

#include "repair/edge_groups.h"

namespace foldwright {
namespace {

constexpr double kWidest = 1e-3;

/// Two unit squares side by side, the second `gap` away from the first.
TriangleSoup squares_apart(double gap) {
  return {{{0, 0, 0},
           {1, 0, 0},
           {1, 1, 0},
           {0, 1, 0},
           {1 + gap, 0, 0},
           {2 + gap, 0, 0},
           {2 + gap, 1, 0},
           {1 + gap, 1, 0}},
          {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}},
          {0, 0, 1, 1},
          {}};
}

TEST(CloseCracks, JoinsBordersUpToTheWidestCrack) {
  TriangleSoup soup = squares_apart(0.9e-3);
  const ClosedCracks closed = close_cracks(soup, kWidest);
  EXPECT_EQ(closed.edges, 2);
  EXPECT_NEAR(closed.width, 0.9e-3, 1e-12);
  EXPECT_EQ(border_half_edges(soup).size(), 6u);
  EXPECT_NEAR(soup.positions[1].x(), 1 + 0.45e-3, 1e-12);
  EXPECT_NEAR(soup.error(1), 0.45e-3, 1e-12);

  TriangleSoup apart = squares_apart(1.1e-3);
  EXPECT_EQ(close_cracks(apart, kWidest).edges, 0);
  EXPECT_EQ(border_half_edges(apart).size(), 8u);
}

TEST(CloseCracks, LeavesGapsThatAreWideAgainstTheEdgesBesideThem) {
  TriangleSoup soup = squares_apart(0.2);
  EXPECT_EQ(close_cracks(soup, 0.5).edges, 0);
}

TEST(CloseCracks, PutsVerticesOnEdgesAcrossACrack) {
  // The second square's border is in two pieces.
  TriangleSoup soup = squares_apart(0.5e-3);
  soup.positions.emplace_back(1 + 0.5e-3, 0.5, 0);
  soup.faces = {{0, 1, 2}, {0, 2, 3}, {4, 5, 8}, {5, 6, 8}, {6, 7, 8}};
  soup.source_faces = {0, 0, 1, 1, 1};
  const ClosedCracks closed = close_cracks(soup, kWidest);
  EXPECT_GT(closed.edges, 0);
  EXPECT_LE(closed.width, 0.5e-3 + 1e-12);
}

TEST(CloseCracks, LeavesSheetsInLayers) {
  TriangleSoup soup = squares_apart(0);
  for (int v = 4; v < 8; ++v) soup.positions[v] = soup.positions[v - 4] + Vec3(0, 0, 0.5e-3);
  EXPECT_EQ(close_cracks(soup, kWidest).edges, 0);
}

}  // namespace
}  // namespace foldwright
