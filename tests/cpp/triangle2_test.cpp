#include "geometry/triangle2.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "geometry/random.h"
#include "unfold/layout.h"

namespace foldwright::testing {
namespace {

constexpr double kTolerance = 1e-9;

double area(const Triangle2& t) { return 0.5 * cross(t[1] - t[0], t[2] - t[0]); }

Vec2 random_point(Random& random) { return {random.uniform(), random.uniform()}; }

/// Counter-clockwise triangle in the unit square, possibly a thin one.
Triangle2 random_triangle(Random& random) {
  while (true) {
    Triangle2 t = {random_point(random), random_point(random), random_point(random)};
    if (area(t) < 0) std::swap(t[1], t[2]);
    if (area(t) > 1e-6) return t;
  }
}

Triangle2 scaled(const Triangle2& t, double factor) {
  return {factor * t[0], factor * t[1], factor * t[2]};
}

/// The triangle over the same first edge, on its other side.
Triangle2 mirrored(const Triangle2& t) {
  const Vec2 along = (t[1] - t[0]).normalized();
  const Vec2 foot = t[0] + along.dot(t[2] - t[0]) * along;
  return {t[1], t[0], 2 * foot - t[2]};
}

TEST(Triangles, OverlapExactlyWhenTheyShareArea) {
  Random random(1);
  int overlapping = 0;
  for (int i = 0; i < 20000; ++i) {
    SCOPED_TRACE(i);
    const Triangle2 a = random_triangle(random);
    const Triangle2 b = random_triangle(random);
    const double shared = intersection_area(a, b);
    if (triangles_overlap(a, b, kTolerance)) {
      ++overlapping;
      EXPECT_GT(shared, 0);
    } else {
      EXPECT_LE(shared, 2 * kTolerance);  // as deep as the tolerance, as long as the square allows
    }
  }
  EXPECT_GT(overlapping, 5000);
  EXPECT_LT(overlapping, 15000);
}

TEST(Triangles, OverlapIsSymmetricAndIndependentOfScale) {
  Random random(2);
  for (int i = 0; i < 5000; ++i) {
    SCOPED_TRACE(i);
    const Triangle2 a = random_triangle(random);
    const Triangle2 b = random_triangle(random);
    const bool overlap = triangles_overlap(a, b, kTolerance);
    EXPECT_EQ(triangles_overlap(b, a, kTolerance), overlap);
    for (const double factor : {0x1p-100, 0x1p100}) {
      EXPECT_EQ(triangles_overlap(scaled(a, factor), scaled(b, factor), factor * kTolerance),
                overlap);
    }
  }
}

TEST(Triangles, TouchingAlongAnEdgeIsNoOverlap) {
  Random random(3);
  for (int i = 0; i < 5000; ++i) {
    SCOPED_TRACE(i);
    const Triangle2 a = random_triangle(random);
    EXPECT_FALSE(triangles_overlap(a, mirrored(a), kTolerance));
    EXPECT_LT(intersection_area(a, mirrored(a)), kTolerance);
    EXPECT_TRUE(triangles_overlap(a, a, kTolerance));
    EXPECT_NEAR(intersection_area(a, a), area(a), 1e-12);
  }
}

TEST(Triangles, TouchingInACornerIsNoOverlap) {
  // A full turn of wedges around a corner: each meets all others there or along an edge.
  Random random(4);
  for (int round = 0; round < 200; ++round) {
    SCOPED_TRACE(round);
    const int count = 3 + random.below(20);
    const Vec2 centre = random_point(random);
    std::vector<Vec2> rim;
    for (int i = 0; i < count; ++i) {
      const double angle = 2 * std::numbers::pi * i / count;
      rim.push_back(centre + (0.1 + random.uniform()) * Vec2(std::cos(angle), std::sin(angle)));
    }
    for (int i = 0; i < count; ++i) {
      for (int j = 0; j < i; ++j) {
        EXPECT_FALSE(triangles_overlap({centre, rim[i], rim[(i + 1) % count]},
                                       {centre, rim[j], rim[(j + 1) % count]}, kTolerance));
      }
    }
  }
}

TEST(Triangles, SliversOverlapDeeperThanTheToleranceOnly) {
  const Triangle2 triangle = {Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)};
  const Triangle2 across = {Vec2(-1, 0.2), Vec2(2, 0.2), Vec2(2, 0.2 + 1e-6)};
  EXPECT_TRUE(triangles_overlap(triangle, across, kTolerance));
  EXPECT_TRUE(triangles_overlap(triangle, across, 1e-5));  // no small shift would part them
  const auto strip_below = [](double depth) {
    return Triangle2{Vec2(0, -1), Vec2(1, depth), Vec2(0, depth)};
  };
  EXPECT_TRUE(triangles_overlap(triangle, strip_below(1e-6), kTolerance));
  EXPECT_FALSE(triangles_overlap(triangle, strip_below(0.5e-9), kTolerance));
  EXPECT_FALSE(triangles_overlap(triangle, strip_below(-1e-6), kTolerance));
}

TEST(Triangles, IntersectionAreaByHand) {
  const Triangle2 half_square = {Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)};
  const auto shifted = [&](double x, double y) { return moved({1, 0, Vec2(x, y)}, half_square); };
  EXPECT_DOUBLE_EQ(intersection_area(half_square, shifted(0.5, 0)), 0.125);
  EXPECT_DOUBLE_EQ(intersection_area(half_square, shifted(0, -0.5)), 0.125);
  EXPECT_DOUBLE_EQ(intersection_area(half_square, shifted(0.25, 0.25)), 0.125);
  EXPECT_EQ(intersection_area(half_square, shifted(1, 0)), 0);
  EXPECT_EQ(intersection_area(half_square, shifted(5, 5)), 0);
  const Triangle2 large = {Vec2(-9, -9), Vec2(9, -9), Vec2(0, 9)};
  EXPECT_DOUBLE_EQ(intersection_area(large, half_square), 0.5);
  EXPECT_DOUBLE_EQ(intersection_area(half_square, large), 0.5);
}

TEST(Box2, EnclosesATriangleAndMeetsByItsInside) {
  const Box2 box = box_of(Triangle2{Vec2(1, 2), Vec2(4, 0), Vec2(3, 5)});
  EXPECT_EQ(box.min[0], 1);
  EXPECT_EQ(box.min[1], 0);
  EXPECT_EQ(box.max[0], 4);
  EXPECT_EQ(box.max[1], 5);
  EXPECT_TRUE(box.meets({3.9, 4.9, 9, 9}));
  EXPECT_FALSE(box.meets({4, 0, 9, 9}));
}

}  // namespace
}  // namespace foldwright::testing
