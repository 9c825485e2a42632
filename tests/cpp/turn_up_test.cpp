#include "read/turn_up.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>

namespace foldwright::testing {
namespace {

Vec3 turned(Vec3 p, Axis up) {
  turn_up({&p, 1}, up);
  return p;
}

/// Of the coordinates, whatever their places and signs.
std::multiset<double> lengths(const Vec3& p) {
  return {std::abs(p.x()), std::abs(p.y()), std::abs(p.z())};
}

TEST(TurnUp, MakesTheAxisY) {
  EXPECT_EQ(turned({1, 0, 0}, Axis::kX), Vec3(0, 1, 0));
  EXPECT_EQ(turned({0, 1, 0}, Axis::kY), Vec3(0, 1, 0));
  EXPECT_EQ(turned({0, 0, 1}, Axis::kZ), Vec3(0, 1, 0));
}

TEST(TurnUp, KeepsAnotherAxis) {
  EXPECT_EQ(turned({0, 0, 7}, Axis::kX), Vec3(0, 0, 7));
  EXPECT_EQ(turned({7, 0, 0}, Axis::kZ), Vec3(7, 0, 0));
}

TEST(TurnUp, MirrorsNothingAndLosesNoBit) {
  const std::array<Vec3, 3> corners = {Vec3(0.1, 1.0 / 3, 1e-300), Vec3(3, -1, 2), Vec3(5, 4, -6)};
  const double volume = corners[0].dot(corners[1].cross(corners[2]));
  for (const Axis up : {Axis::kX, Axis::kY, Axis::kZ}) {
    std::array<Vec3, 3> copy = corners;
    turn_up(copy, up);
    EXPECT_NEAR(copy[0].dot(copy[1].cross(copy[2])), volume, 1e-12);
    EXPECT_EQ(lengths(copy[0]), lengths(corners[0]));
  }
}

TEST(TurnUp, MakesNoNegativeZeros) {
  for (const Axis up : {Axis::kX, Axis::kZ}) {
    const Vec3 p = turned({0, 0, 0}, up);
    for (int axis = 0; axis < 3; ++axis) EXPECT_FALSE(std::signbit(p[axis]));
  }
}

}  // namespace
}  // namespace foldwright::testing
