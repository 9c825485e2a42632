#include "repair/drawn_planes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace foldwright {
namespace {

/// A square bent along its diagonal by an angle, of one polygon or two, with errors of vertices.
TriangleSoup bent_square(double degrees, bool is_one_polygon, double error) {
  const double rise = std::tan(degrees * std::numbers::pi / 180) / std::sqrt(2.0);
  return {{{0, 0, 0}, {1, 0, 0}, {1, 1, rise}, {0, 1, 0}},
          {{0, 1, 3}, {1, 2, 3}},
          {0, is_one_polygon ? 0 : 1},
          std::vector<double>(4, error)};
}

std::size_t planes(const TriangleSoup& soup) { return find_drawn_planes(soup).size(); }

TEST(DrawnPlanes, JoinTrianglesAsFarAsErrorsExplain) {
  EXPECT_EQ(planes(bent_square(0.5, false, 0)), 0u);
  EXPECT_EQ(planes(bent_square(0.5, false, 1e-4)), 0u);  // explains 0.05 degrees
  EXPECT_EQ(planes(bent_square(0.5, false, 5e-3)), 1u);
  EXPECT_EQ(planes(bent_square(1.5, false, 5e-3)), 0u);  // explained as well, but genuine
  EXPECT_EQ(planes(bent_square(0.0009, false, 0)), 1u);
}

TEST(DrawnPlanes, JoinTrianglesOfAPolygonThatIsNearlyFlat) {
  EXPECT_EQ(planes(bent_square(0.1, true, 0)), 1u);
  EXPECT_EQ(planes(bent_square(2, true, 0)), 0u);
  EXPECT_EQ(planes(bent_square(2, true, 0.01)), 1u);   // explained
  EXPECT_EQ(planes(bent_square(30, true, 0.12)), 0u);  // clearly bent, whatever errors explain
}

/// Half a cylinder of `sides` squares of side 1, each in two triangles; every edge errs.
TriangleSoup arch(int sides, double error) {
  TriangleSoup soup;
  const double step = std::numbers::pi / sides;
  const double radius = 0.5 / std::sin(step / 2);
  for (int i = 0; i <= sides; ++i) {
    for (const double z : {0.0, 1.0}) {
      soup.positions.emplace_back(radius * std::cos(step * i), radius * std::sin(step * i), z);
    }
    if (i == sides) break;
    soup.faces.insert(soup.faces.end(),
                      {{2 * i, 2 * i + 2, 2 * i + 3}, {2 * i, 2 * i + 3, 2 * i + 1}});
    soup.source_faces.insert(soup.source_faces.end(), {2 * i, 2 * i + 1});
  }
  soup.errors.assign(soup.positions.size(), error);
  return soup;
}

TEST(DrawnPlanes, DoNotDriftRoundACylinder) {
  // Steps of 0.6 degrees: none is genuine by itself where errors explain 0.4 degrees and more.
  for (const double error : {1e-6, 1e-4, 1e-3, 3e-3}) {
    for (const std::vector<int>& plane : find_drawn_planes(arch(300, error))) {
      EXPECT_LE(plane.size(), 8u) << error;
    }
  }
  EXPECT_EQ(planes(arch(300, 1e-6)), 300u);
}

}  // namespace
}  // namespace foldwright
