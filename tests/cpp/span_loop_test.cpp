#include "repair/span_loop.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "geometry/random.h"

namespace foldwright::testing {
namespace {

using Triangles = std::vector<std::array<int, 3>>;

Vec3 area_vector(const std::vector<Vec3>& loop, const std::array<int, 3>& t) {
  return 0.5 * (loop[t[1]] - loop[t[0]]).cross(loop[t[2]] - loop[t[0]]);
}

double area(const std::vector<Vec3>& loop, const Triangles& triangles) {
  double sum = 0;
  for (const auto& t : triangles) sum += area_vector(loop, t).norm();
  return sum;
}

/// That each edge of the loop has one triangle along it, and every other edge two that disagree.
void expect_spanned(const Triangles& triangles, int count) {
  EXPECT_EQ(static_cast<int>(triangles.size()), count - 2);
  std::set<std::pair<int, int>> directed;
  for (const auto& t : triangles) {
    for (int i = 0; i < 3; ++i) EXPECT_TRUE(directed.insert({t[i], t[(i + 1) % 3]}).second);
  }
  for (const auto& [from, to] : directed) {
    EXPECT_NE((from + 1) % count == to, directed.contains({to, from})) << from << ' ' << to;
  }
}

/// A circle of radius 1 in the plane whose height at an angle `wave` tells.
template <class Wave>
std::vector<Vec3> circle(int count, Wave&& wave) {
  std::vector<Vec3> loop;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    loop.emplace_back(std::cos(angle), std::sin(angle), wave(angle));
  }
  return loop;
}

TEST(SpanLoop, CoversFlatLoopsOnce) {
  // A flag with two tails: its area is that of the polygon only if nothing lies outside.
  const std::vector<Vec3> flag = {{0, 0, 0}, {4, 0, 0}, {2, 1, 0}, {4, 2, 0}, {0, 2, 0}};
  const Triangles spanned = span_loop(flag, {});
  expect_spanned(spanned, 5);
  EXPECT_NEAR(area(flag, spanned), 6, 1e-12);
  for (const auto& t : spanned) EXPECT_GT(area_vector(flag, t).z(), 0);
}

TEST(SpanLoop, MakesWellShapedTriangles) {
  const std::vector<Vec3> loop = circle(12, [](double) { return 0; });
  double longest = 0;
  for (const auto& t : span_loop(loop, {})) {
    for (int i = 0; i < 3; ++i) {
      longest = std::max(longest, (loop[t[i]] - loop[t[(i + 1) % 3]]).norm());
    }
  }
  // The sides of the inscribed triangle: of a fan, some are 2.
  EXPECT_NEAR(longest, std::sqrt(3), 1e-9);
}

TEST(SpanLoop, TakesTheFlatterWayAcrossABentLoop) {
  // A square folded along one of its diagonals is two flat triangles only across that one.
  const std::vector<Vec3> folded = {{0, 0, 0}, {1, 0, 0.4}, {1, 1, 0}, {0, 1, 0.4}};
  const Triangles spanned = span_loop(folded, {});
  expect_spanned(spanned, 4);
  EXPECT_NEAR(area(folded, spanned),
              std::min(area(folded, {{0, 1, 2}, {0, 2, 3}}), area(folded, {{1, 2, 3}, {1, 3, 0}})),
              1e-12);
}

TEST(SpanLoop, HasNoMoreAreaThanAnyFan) {
  const std::vector<Vec3> wavy = circle(24, [](double t) { return 0.3 * std::sin(3 * t); });
  const Triangles spanned = span_loop(wavy, {});
  expect_spanned(spanned, 24);
  for (int tip = 0; tip < 24; ++tip) {
    Triangles fan;
    for (int i = 1; i < 23; ++i) fan.push_back({tip, (tip + i) % 24, (tip + i + 1) % 24});
    EXPECT_LT(area(wavy, spanned), area(wavy, fan));
  }
}

TEST(SpanLoop, SpansRandomFlatStarsExactly) {
  Random random(7);
  for (int round = 0; round < 20; ++round) {
    const int count = 5 + round;
    std::vector<Vec3> star = circle(count, [](double) { return 0; });
    double wanted = 0;
    for (Vec3& p : star) p *= 0.2 + random.uniform();
    for (int i = 0; i < count; ++i) wanted += 0.5 * star[i].cross(star[(i + 1) % count]).z();
    const Triangles spanned = span_loop(star, {});
    expect_spanned(spanned, count);
    EXPECT_NEAR(area(star, spanned), wanted, 1e-9) << "round " << round;
  }
}

TEST(SpanLoop, KeepsToItsLimits) {
  const std::vector<Vec3> square = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const auto no_02 = [](int i, int j) { return i == 0 && j == 2; };
  for (const auto& t : span_loop(square, {.is_taken = no_02})) {
    EXPECT_NE(t[0] + t[1] + t[2], 0 + 1 + 2);
    EXPECT_NE(t[0] + t[1] + t[2], 0 + 2 + 3);
  }
  EXPECT_TRUE(span_loop(square, {.is_taken = [](int, int) { return true; }}).empty());
  const std::vector<Vec3> slit = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1e-9, 0}};
  EXPECT_TRUE(span_loop(slit, {.least_height = 1e-6}).empty());
}

TEST(SpanLoop, SpansVeryLongLoops) {
  const std::vector<Vec3> loop = circle(1000, [](double t) { return 0.05 * std::sin(2 * t); });
  expect_spanned(span_loop(loop, {}), 1000);
}

}  // namespace
}  // namespace foldwright::testing
