#include "paper/turns.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace foldwright::testing {
namespace {

const std::vector<Vec2> kRectangle = {{0, 0}, {4, 0}, {4, 1}, {0, 1}, {2, 0.5}, {2, 0}};

TEST(ConvexHull, KeepsTheCornersAlone) {
  const std::vector<Vec2> hull = convex_hull(kRectangle);
  ASSERT_EQ(hull.size(), 4u);
  double twice = 0;
  for (std::size_t i = 0; i < 4; ++i) twice += cross(hull[i], hull[(i + 1) % 4]);
  EXPECT_DOUBLE_EQ(twice, 8) << "counter-clockwise";
}

TEST(UprightTurns, FindTheSmallestBox) {
  std::vector<Vec2> turned;
  for (const Vec2& p : kRectangle) {
    turned.emplace_back(0.8 * p.x() - 0.6 * p.y(), 0.6 * p.x() + 0.8 * p.y());
  }
  double least = 1e300;
  for (const Turn& turn : upright_turns(convex_hull(turned))) {
    EXPECT_NEAR(turn.c * turn.c + turn.s * turn.s, 1, 1e-12);
    least = std::min(least, turn.box.width * turn.box.height);
  }
  EXPECT_NEAR(least, 4, 1e-12);
}

}  // namespace
}  // namespace foldwright::testing
