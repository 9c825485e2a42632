#include "simplify/face_shape.h"

#include <gtest/gtest.h>

#include <cmath>

namespace foldwright::testing {
namespace {

/// Isosceles triangle over a base along x.
Triangle3 isosceles(double base, double height) {
  return {Vec3(0, 0, 0), Vec3(base, 0, 0), Vec3(base / 2, height, 0)};
}

TEST(ShapeCost, IsNothingForWellShapedTriangles) {
  EXPECT_EQ(shape_cost(isosceles(1, std::sqrt(3) / 2), 1), 0);
  EXPECT_EQ(shape_cost(isosceles(3, 2), 1), 0);
}

TEST(ShapeCost, GrowsWithThinness) {
  double before = 0;
  for (const double height : {0.3, 0.2, 0.1, 0.0}) {
    const double cost = shape_cost(isosceles(1, height), 1);
    EXPECT_GT(cost, before);
    before = cost;
  }
}

TEST(ShapeCost, CountsTinyTrianglesAsLowHoweverWellShaped) {
  EXPECT_GT(shape_cost(isosceles(0.1, 0.09), 1), shape_cost(isosceles(0.2, 0.18), 1));
  EXPECT_GT(shape_cost(isosceles(0.2, 0.18), 1), 0);
}

TEST(ShapeCost, IsTheSameAtEveryScale) {
  const double cost = shape_cost(isosceles(1, 0.1), 1);
  EXPECT_NEAR(shape_cost(isosceles(10, 1), 10), 1e4 * cost, 1e-9 * 1e4);
}

TEST(ShapeCost, IsFiniteForATriangleWithoutSize) {
  EXPECT_GT(shape_cost(isosceles(0, 0), 1), 0);
  EXPECT_TRUE(std::isfinite(shape_cost(isosceles(0, 0), 1)));
}

TEST(KeepsFacing, RefusesTurnsAndNeedles) {
  const Triangle3 flat = isosceles(1, 1);
  EXPECT_TRUE(keeps_facing(flat, flat));
  EXPECT_FALSE(keeps_facing(flat, {flat[0], flat[2], flat[1]}));
  EXPECT_TRUE(keeps_facing(flat, {flat[0], flat[1], Vec3(0.5, 0.5, 0.8)}));   // 58 degrees
  EXPECT_FALSE(keeps_facing(flat, {flat[0], flat[1], Vec3(0.5, 0.2, 0.8)}));  // 76 degrees
  EXPECT_FALSE(keeps_facing(flat, isosceles(1, 1e-4)));
}

}  // namespace
}  // namespace foldwright::testing
