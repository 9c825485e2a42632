#include "repair/triangulate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/random.h"

namespace foldwright {
namespace {

using Triangles = std::vector<std::array<int, 3>>;

/// Sum of the triangles' areas, and smallest of them when seen against `normal`.
struct Areas {
  double sum = 0;
  double smallest = 1e300;
};

Areas areas_of(const std::vector<Vec3>& p, const Triangles& triangles, const Vec3& normal) {
  Areas areas;
  for (const auto& [a, b, c] : triangles) {
    const double area = 0.5 * (p[b] - p[a]).cross(p[c] - p[a]).dot(normal);
    areas.sum += std::abs(area);
    areas.smallest = std::min(areas.smallest, area);
  }
  return areas;
}

bool uses_diagonal(const Triangles& triangles, int a, int b) {
  return std::all_of(triangles.begin(), triangles.end(), [&](const auto& t) {
    return std::count(t.begin(), t.end(), a) + std::count(t.begin(), t.end(), b) == 2;
  });
}

TEST(Triangulate, CutsPlanarQuadsAlongTheShorterDiagonal) {
  EXPECT_TRUE(uses_diagonal(
      triangulate(std::vector<Vec3>{{0, 0, 0}, {2, -1, 0}, {4, 0, 0}, {2, 1, 0}}), 1, 3));
  EXPECT_TRUE(uses_diagonal(
      triangulate(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}), 0, 2));
}

TEST(Triangulate, CutsConcaveQuadsInside) {
  const std::vector<Vec3> arrow = {
      {0, 0, 0}, {4, 1, 0}, {1, 0, 0}, {4, -1, 0}};  // notch at corner 2
  EXPECT_TRUE(uses_diagonal(triangulate(arrow), 0, 2));
}

TEST(Triangulate, CutsBentQuadsSoThatTheyBendLess) {
  Random random(2);
  for (int round = 0; round < 100; ++round) {
    std::vector<Vec3> quad = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    for (Vec3& p : quad) p += 0.3 * Vec3(random.uniform(), random.uniform(), random.uniform());
    const auto bend = [&](int apex_1, int from, int to, int apex_2) {
      const Vec3 n1 = (quad[from] - quad[apex_1]).cross(quad[to] - quad[apex_1]).normalized();
      const Vec3 n2 = (quad[to] - quad[apex_2]).cross(quad[from] - quad[apex_2]).normalized();
      return (n1 - n2).norm();
    };
    const bool along_02 = bend(1, 2, 0, 3) < bend(0, 1, 3, 2);
    EXPECT_TRUE(uses_diagonal(triangulate(quad), along_02 ? 0 : 1, along_02 ? 2 : 3)) << round;
  }
}

TEST(Triangulate, DoesNotCutThroughACollinearCorner) {
  const std::vector<Vec3> quad = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 0.2, 0}};
  EXPECT_TRUE(uses_diagonal(triangulate(quad), 1, 3));
  const std::vector<Vec3> pentagon = {{0, 0, 0}, {0.5, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  EXPECT_GT(areas_of(pentagon, triangulate(pentagon), Vec3::UnitZ()).smallest, 0.1);
}

TEST(Triangulate, ClipsConcavePolygonsOfAnyOrientationInSpace) {
  Random random(11);
  for (int round = 0; round < 50; ++round) {
    // A star-shaped polygon with random radii, turned at random.
    const int corners = 5 + random.below(40);
    const Vec3 x =
        Vec3(random.uniform() - 0.5, random.uniform() - 0.5, random.uniform()).normalized();
    const Vec3 y = x.unitOrthogonal();
    std::vector<Vec3> polygon;
    double area = 0;
    double previous_radius = 0;
    double first_radius = 0;
    const double step = 2 * std::numbers::pi / corners;
    for (int i = 0; i < corners; ++i) {
      const double radius = 0.2 + random.uniform();
      polygon.push_back(radius * (std::cos(i * step) * x + std::sin(i * step) * y));
      if (i == 0) first_radius = radius;
      if (i > 0) area += 0.5 * std::sin(step) * radius * previous_radius;
      previous_radius = radius;
    }
    area += 0.5 * std::sin(step) * first_radius * previous_radius;
    const Triangles triangles = triangulate(polygon);
    EXPECT_EQ(triangles.size(), polygon.size() - 2);
    const Areas areas = areas_of(polygon, triangles, x.cross(y));
    EXPECT_NEAR(areas.sum, area, 1e-9) << round;
    EXPECT_GT(areas.smallest, 0) << round;
  }
}

TEST(Triangulate, BridgesAHole) {
  // Square of side 3 with a square hole of side 1, joined by a bridge that is walked twice.
  const std::vector<Vec3> p = {{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0}, {0, 0, 0},
                               {1, 1, 0}, {1, 2, 0}, {2, 2, 0}, {2, 1, 0}, {1, 1, 0}};
  const Areas areas = areas_of(p, triangulate(p), Vec3::UnitZ());
  EXPECT_NEAR(areas.sum, 8, 1e-12);
  EXPECT_GE(areas.smallest, 0);
}

TEST(Triangulate, KeepsTheCountWhenAPolygonCrossesItself) {
  const std::vector<Vec3> pentagram = {
      {0, 1, 0}, {-0.6, -0.8, 0}, {0.95, 0.3, 0}, {-0.95, 0.3, 0}, {0.6, -0.8, 0}};
  EXPECT_EQ(triangulate(pentagram).size(), 3u);
  const std::vector<Vec3> line = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}};
  EXPECT_EQ(triangulate(line).size(), 3u);
}

TEST(Triangulate, LeavesNoNeedlesBetweenCornersInLine) {
  // An L, whose inner corner is in line with two outer ones up to rounding.
  const std::vector<Vec3> corners = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0},
                                     {1, 1, 0}, {1, 2, 0}, {-1e-4, 2, 0}};
  for (const auto& [a, b, c] : triangulate(corners)) {
    EXPECT_GT((corners[b] - corners[a]).cross(corners[c] - corners[a]).z(), 0.1);
  }
}

}  // namespace
}  // namespace foldwright
