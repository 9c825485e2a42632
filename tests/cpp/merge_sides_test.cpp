#include "repair/merge_sides.h"

#include <gtest/gtest.h>

namespace foldwright {
namespace {

constexpr double kTolerance = 1e-6;

const std::vector<Vec3> kSquare = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};

TEST(MergeSides, DropsAQuadRepeatedByTheOtherDiagonal) {
  TriangleSoup soup{kSquare, {{0, 1, 2}, {0, 2, 3}, {1, 2, 3}, {1, 3, 0}}, {4, 5, 6, 7}, {}};
  EXPECT_TRUE(merge_sides(soup, kTolerance).empty());
  EXPECT_EQ(soup.source_faces, (std::vector<int>{4, 5}));
}

TEST(MergeSides, MakesOneSkinOfAQuadAndItsBackByTheOtherDiagonal) {
  TriangleSoup soup{kSquare, {{0, 1, 2}, {0, 2, 3}, {3, 2, 1}, {0, 3, 1}}, {0, 0, 1, 1}, {}};
  EXPECT_EQ(merge_sides(soup, kTolerance), (std::vector<int>{1, 1}));
  EXPECT_EQ(soup.face_count(), 2);
}

TEST(MergeSides, LeavesATetrahedronHoweverThin) {
  // Its faces are pairs over the same four corners by either diagonal, but in no plane.
  const std::vector<Vec3> corners = {{0, 0, 0}, {1, 0, 1e-3}, {1, 1, 0}, {0, 1, 1e-3}};
  TriangleSoup soup{corners, {{0, 1, 2}, {0, 2, 3}, {3, 2, 1}, {0, 3, 1}}, {0, 1, 2, 3}, {}};
  merge_sides(soup, kTolerance);
  EXPECT_EQ(soup.face_count(), 4);
}

TEST(MergeSides, LeavesAWallBetweenRooms) {
  // Two tetrahedra on either side of the triangle 0 1 2, which both have.
  TriangleSoup soup{
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}},
      {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {0, 1, 2}, {1, 0, 4}, {2, 1, 4}, {0, 2, 4}},
      {0, 1, 2, 3, 4, 5, 6, 7},
      {}};
  merge_sides(soup, kTolerance);
  EXPECT_EQ(soup.face_count(), 8);
}

TEST(MergeSides, MakesOneSkinOfAFaceGivenTwiceInAClosedBody) {
  TriangleSoup soup{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                    {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {0, 1, 2}},
                    {0, 1, 2, 3, 4},
                    {}};
  EXPECT_EQ(merge_sides(soup, kTolerance), std::vector<int>{4});
  EXPECT_EQ(soup.face_count(), 4);
}

}  // namespace
}  // namespace foldwright
