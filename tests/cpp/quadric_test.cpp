#include "simplify/quadric.h"

#include <gtest/gtest.h>

namespace foldwright::testing {
namespace {

TEST(Quadric, SumsWeightedSquaredDistances) {
  Quadric quadric;
  quadric.add_plane(Vec3::UnitZ(), {0, 0, 1}, 2);
  quadric.add_plane(Vec3(0.6, 0.8, 0), {0, 0, 0}, 3);
  EXPECT_NEAR(quadric.at({1, 2, 5}), 2 * 16 + 3 * 2.2 * 2.2, 1e-12);
  Quadric doubled = quadric;
  doubled += quadric;
  EXPECT_NEAR(doubled.at({1, 2, 5}), 2 * quadric.at({1, 2, 5}), 1e-12);
}

TEST(Quadric, FindsTheCornerOfThreePlanes) {
  Quadric quadric;
  quadric.add_plane(Vec3::UnitX(), {1, 0, 0}, 1);
  quadric.add_plane(Vec3::UnitY(), {0, 2, 0}, 0.1);
  quadric.add_plane(Vec3(1, 1, 1).normalized(), {1, 2, 3}, 5);
  EXPECT_LT((quadric.least_near({9, 9, 9}) - Vec3(1, 2, 3)).norm(), 1e-9);
}

TEST(Quadric, StaysWhereThePlanesLeaveItFree) {
  Quadric flat;
  flat.add_plane(Vec3::UnitZ(), {0, 0, 1}, 1);
  EXPECT_LT((flat.least_near({4, 5, 6}) - Vec3(4, 5, 1)).norm(), 1e-12);
  Quadric crease = flat;
  crease.add_plane(Vec3::UnitX(), {2, 0, 0}, 1);
  EXPECT_LT((crease.least_near({4, 5, 6}) - Vec3(2, 5, 1)).norm(), 1e-12);
}

TEST(Quadric, MovesWithinAPlane) {
  Quadric quadric;
  quadric.add_plane(Vec3::UnitZ(), {0, 0, 1}, 1);
  quadric.add_plane(Vec3::UnitX(), {2, 0, 0}, 1);
  const Vec3 across = Vec3::UnitX();
  EXPECT_LT((quadric.least_near({4, 5, 6}, &across) - Vec3(4, 5, 1)).norm(), 1e-12);
}

}  // namespace
}  // namespace foldwright::testing
