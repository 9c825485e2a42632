#include "geometry/rigid_motion3.h"

#include <gtest/gtest.h>

#include <numbers>

#include "geometry/random.h"

namespace foldwright::testing {
namespace {

Vec3 random_point(Random& random) {
  const auto coordinate = [&] { return 20 * random.uniform() - 10; };
  const double x = coordinate();
  const double y = coordinate();
  return {x, y, coordinate()};
}

RigidMotion3 random_motion(Random& random) {
  const Eigen::Quaterniond r(random.normal(), random.normal(), random.normal(), random.normal());
  return {r.normalized(), random_point(random)};
}

void expect_same(const Vec3& a, const Vec3& b) { EXPECT_LT((a - b).norm(), 1e-12); }

TEST(RigidMotion3, ComposesFromRightToLeft) {
  const RigidMotion3 quarter_turn = turn_about(Vec3::Zero(), Vec3::UnitZ(), 0.5 * std::numbers::pi);
  const RigidMotion3 step{Eigen::Quaterniond::Identity(), Vec3::UnitX()};
  expect_same((quarter_turn * step)(Vec3::Zero()), Vec3::UnitY());
  expect_same((step * quarter_turn)(Vec3::Zero()), Vec3::UnitX());
  Random random(1);
  for (int i = 0; i < 100; ++i) {
    const RigidMotion3 a = random_motion(random);
    const RigidMotion3 b = random_motion(random);
    const Vec3 p = random_point(random);
    expect_same((a * b)(p), a(b(p)));
  }
}

TEST(RigidMotion3, InverseUndoes) {
  Random random(2);
  for (int i = 0; i < 100; ++i) {
    const RigidMotion3 motion = random_motion(random);
    const Vec3 p = random_point(random);
    expect_same(motion.inverse()(motion(p)), p);
    expect_same((motion * motion.inverse())(p), p);
  }
}

TEST(RigidMotion3, TurnsForwardsAboutALine) {
  const double quarter = 0.5 * std::numbers::pi;
  expect_same(turn_about(Vec3::Zero(), Vec3::UnitX(), quarter)(Vec3::UnitY()), Vec3::UnitZ());
  expect_same(turn_about(Vec3(1, 0, 0), Vec3::UnitZ(), quarter)(Vec3(2, 0, 5)), Vec3(1, 1, 5));
  Random random(3);
  for (int i = 0; i < 100; ++i) {
    const Vec3 point = random_point(random);
    const Vec3 axis = random_point(random).normalized();
    const double angle = 8 * random.uniform() - 4;
    const RigidMotion3 turn = turn_about(point, axis, angle);
    expect_same(turn(point), point);
    expect_same(turn(point + 3 * axis), point + 3 * axis);
    // Rodrigues' formula.
    const Vec3 v = random_point(random) - point;
    const Vec3 expected = std::cos(angle) * v + std::sin(angle) * axis.cross(v) +
                          (1 - std::cos(angle)) * axis.dot(v) * axis;
    expect_same(turn(point + v), point + expected);
    expect_same((turn_about(point, axis, -angle) * turn)(point + v), point + v);
  }
}

TEST(RigidMotion3, SeesMotionsOfThePlaneInSpace) {
  Random random(4);
  for (int i = 0; i < 1000; ++i) {
    // All around, and close to where the halves of the angle change over.
    const double near = 1e-9 * (random.uniform() - 0.5) + 0.5 * std::numbers::pi * (i % 4 - 1);
    const double angle = i < 500 ? 2 * std::numbers::pi * random.uniform() : near;
    const RigidMotion2 flat{std::cos(angle), std::sin(angle), random_point(random).head<2>()};
    const Vec2 p = random_point(random).head<2>();
    const Vec2 moved = flat(p);
    expect_same(in_space(flat)(Vec3(p.x(), p.y(), 2)), Vec3(moved.x(), moved.y(), 2));
  }
  const RigidMotion3 half_turn = in_space({-1, 0, Vec2::Zero()});
  expect_same(half_turn(Vec3(1, 2, 3)), Vec3(-1, -2, 3));
  expect_same(in_space({-1, -0.0, Vec2::Zero()})(Vec3(1, 2, 3)), Vec3(-1, -2, 3));
}

TEST(RigidMotion3, DoesNotDriftOverManyCompositions) {
  Random random(5);
  RigidMotion3 motion;
  for (int i = 0; i < 100000; ++i) {
    RigidMotion3 step = random_motion(random);
    step.r.coeffs() *= 1 + 1e-12;
    motion = motion * step;
  }
  EXPECT_NEAR(motion.r.norm(), 1, 1e-15);
  EXPECT_NEAR((motion(Vec3(3, 4, 12)) - motion(Vec3::Zero())).norm(), 13, 1e-8);
}

}  // namespace
}  // namespace foldwright::testing
