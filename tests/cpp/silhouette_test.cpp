#include "paper/silhouette.h"

#include <gtest/gtest.h>

#include <cmath>

#include "geometry/random.h"

namespace foldwright::testing {
namespace {

Silhouette around(std::span<const Vec2> points) {
  Silhouette silhouette;
  for (const Vec2& p : points) silhouette.add(p);
  return silhouette;
}

std::vector<Vec2> rectangle(double width, double height, double angle) {
  std::vector<Vec2> corners;
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  for (const auto& [x, y] : {std::pair{0.0, 0.0}, {width, 0.0}, {width, height}, {0.0, height}}) {
    corners.emplace_back(7 + c * x - s * y, s * x + c * y - 3);
  }
  return corners;
}

double hull_area(const std::vector<Vec2>& points) {
  const std::vector<Vec2> hull = convex_hull(points);
  double twice = 0;
  for (std::size_t i = 0; i < hull.size(); ++i)
    twice += cross(hull[i], hull[(i + 1) % hull.size()]);
  return 0.5 * twice;
}

TEST(Silhouette, IsEmptyWithoutPoints) {
  EXPECT_EQ(Silhouette().area(), 0);
  EXPECT_EQ(Silhouette().excess({1, 1}), 0);
}

TEST(Silhouette, HasTheAreaOfAnUprightRectangle) {
  EXPECT_NEAR(around(rectangle(30, 20, 0)).area(), 600, 1e-3);
}

TEST(Silhouette, LiesTightlyAroundTheHullOfPoints) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    std::vector<Vec2> points;
    for (int i = 0; i < 60; ++i) points.emplace_back(50 * random.normal(), 50 * random.normal());
    const double area = hull_area(points);
    EXPECT_GE(around(points).area(), area * (1 - 1e-5));
    EXPECT_LE(around(points).area(), area * 1.06);
  }
}

TEST(Silhouette, SticksOutOfARoomByWhatIsTooLong) {
  const Extent room = {190, 277};
  EXPECT_EQ(around(rectangle(180, 270, 0)).excess(room), 0);
  EXPECT_NEAR(around(rectangle(200, 270, 0)).excess(room), 10, 1e-3);
  EXPECT_NEAR(around(rectangle(300, 200, 0)).excess(room), 33, 1e-3);
  // A room may be entered at any of the turns.
  EXPECT_NEAR(around(rectangle(180, 270, 0.5 * 3.14159265358979)).excess(room), 0, 1e-3);
}

}  // namespace
}  // namespace foldwright::testing
