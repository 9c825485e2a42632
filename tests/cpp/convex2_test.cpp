#include "geometry/convex2.h"

#include <gtest/gtest.h>

#include <vector>

#include "geometry/random.h"
#include "geometry/triangle2.h"

namespace foldwright::testing {
namespace {

const std::vector<Vec2> kSquare = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};

std::vector<Vec2> moved(std::vector<Vec2> polygon, const Vec2& by) {
  for (Vec2& p : polygon) p += by;
  return polygon;
}

TEST(ConvexOverlap, TellsTouchingFromOverlapping) {
  EXPECT_TRUE(convex_overlap(kSquare, moved(kSquare, {1, 1}), 0));
  EXPECT_TRUE(convex_overlap(kSquare, kSquare, 0));
  EXPECT_FALSE(convex_overlap(kSquare, moved(kSquare, {2, 0}), 0));
  EXPECT_FALSE(convex_overlap(kSquare, moved(kSquare, {2, 2}), 0));
  EXPECT_FALSE(convex_overlap(kSquare, moved(kSquare, {1.9, 0}), 0.2));
}

TEST(ConvexOverlap, AgreesWithTheTestForTriangles) {
  Random random(7);
  const auto triangle = [&] {
    Triangle2 t;
    do {
      for (Vec2& p : t) p = Vec2(random.uniform(), random.uniform());
    } while (cross(t[1] - t[0], t[2] - t[0]) <= 1e-3);
    return t;
  };
  for (int i = 0; i < 1000; ++i) {
    const Triangle2 a = triangle();
    const Triangle2 b = triangle();
    EXPECT_EQ(convex_overlap(a, b, 1e-9), triangles_overlap(a, b, 1e-9)) << i;
  }
}

}  // namespace
}  // namespace foldwright::testing
