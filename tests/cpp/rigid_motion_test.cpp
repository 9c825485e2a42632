#include "geometry/rigid_motion.h"

#include <gtest/gtest.h>

#include <numbers>

#include "geometry/random.h"

namespace foldwright::testing {
namespace {

Vec2 random_point(Random& random) {
  return {20 * random.uniform() - 10, 20 * random.uniform() - 10};
}

RigidMotion2 random_motion(Random& random) {
  const double angle = 2 * std::numbers::pi * random.uniform();
  return {std::cos(angle), std::sin(angle), random_point(random)};
}

void expect_same(const Vec2& a, const Vec2& b) {
  EXPECT_NEAR(a.x(), b.x(), 1e-12);
  EXPECT_NEAR(a.y(), b.y(), 1e-12);
}

TEST(RigidMotion2, ComposesFromRightToLeft) {
  const RigidMotion2 quarter_turn{0, 1, Vec2::Zero()};
  const RigidMotion2 step{1, 0, Vec2(1, 0)};
  expect_same((quarter_turn * step)(Vec2(0, 0)), Vec2(0, 1));
  expect_same((step * quarter_turn)(Vec2(0, 0)), Vec2(1, 0));
  Random random(1);
  for (int i = 0; i < 100; ++i) {
    const RigidMotion2 a = random_motion(random);
    const RigidMotion2 b = random_motion(random);
    const Vec2 p = random_point(random);
    expect_same((a * b)(p), a(b(p)));
  }
}

TEST(RigidMotion2, InverseUndoes) {
  Random random(2);
  for (int i = 0; i < 100; ++i) {
    const RigidMotion2 motion = random_motion(random);
    const Vec2 p = random_point(random);
    expect_same(motion.inverse()(motion(p)), p);
    expect_same((motion * motion.inverse())(p), p);
  }
}

TEST(RigidMotion2, TakesASegmentOntoAnother) {
  Random random(3);
  for (int i = 0; i < 100; ++i) {
    const Vec2 a = random_point(random);
    const Vec2 b = random_point(random);
    const RigidMotion2 hidden = random_motion(random);
    const RigidMotion2 found = motion_onto(a, b, hidden(a), hidden(b));
    const Vec2 elsewhere = random_point(random);
    EXPECT_LT((found(elsewhere) - hidden(elsewhere)).norm(), 1e-9);
  }
}

TEST(RigidMotion2, SharesADifferenceInLengthBetweenTheEnds) {
  const RigidMotion2 motion = motion_onto(Vec2(0, 0), Vec2(2, 0), Vec2(5, 0), Vec2(5, 2.2));
  expect_same(motion(Vec2(0, 0)), Vec2(5, 0.1));
  expect_same(motion(Vec2(2, 0)), Vec2(5, 2.1));
}

TEST(RigidMotion2, DoesNotDriftOverManyCompositions) {
  Random random(4);
  RigidMotion2 motion;
  for (int i = 0; i < 100000; ++i) {
    RigidMotion2 step = random_motion(random);
    step.c *= 1 + 1e-12;  // as much as the sloppiest input may have
    step.s *= 1 + 1e-12;
    motion = motion * step;
  }
  EXPECT_NEAR(std::hypot(motion.c, motion.s), 1, 1e-15);
  EXPECT_NEAR((motion(Vec2(3, 4)) - motion(Vec2(0, 0))).norm(), 5, 1e-11);
}

}  // namespace
}  // namespace foldwright::testing
