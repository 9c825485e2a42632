#include "simplify/surface_quadrics.h"

#include <gtest/gtest.h>

#include "meshes.h"

namespace foldwright::testing {
namespace {

TEST(SurfaceQuadrics, CountMovesOffTheFacesAlone) {
  const Mesh sheet = open_sheet(2);
  const std::vector<Quadric> quadrics = surface_quadrics(sheet, {}, std::nullopt);
  const int middle = 4;  // six faces of half a unit, a third of each
  const Vec3& p = sheet.positions[middle];
  EXPECT_NEAR(quadrics[middle].at(p + Vec3(0.3, -0.2, 0)), 0, 1e-12);
  EXPECT_NEAR(quadrics[middle].at(p + Vec3(0, 0, 2)), 4, 1e-12);
}

TEST(SurfaceQuadrics, HoldCornersOfABorderAndItsEdges) {
  const Mesh sheet = open_sheet(2);
  const std::vector<Quadric> quadrics = surface_quadrics(sheet, {}, std::nullopt);
  EXPECT_GT(quadrics[0].at({0.1, 0, 0}), 0.01);
  EXPECT_GT(quadrics[0].at({0, 0.1, 0}), 0.01);
  EXPECT_NEAR(quadrics[1].at({1.1, 0, 0}), 0, 1e-12);
  EXPECT_GT(quadrics[1].at({1, 0.1, 0}), 0.01);
}

TEST(SurfaceQuadrics, HoldBordersBetweenRegions) {
  const Mesh sheet = open_sheet(2);
  std::vector<int> regions;
  for (const auto& face : sheet.faces) {
    double x = 0;
    for (const int v : face) x += sheet.positions[v].x() / 3;
    regions.push_back(x < 1);
  }
  const std::vector<Quadric> quadrics = surface_quadrics(sheet, regions, std::nullopt);
  EXPECT_NEAR(quadrics[4].at({1, 1.2, 0}), 0, 1e-12);
  EXPECT_GT(quadrics[4].at({1.2, 1, 0}), 0.01);
}

TEST(SurfaceQuadrics, LeaveWhatLiesOnThePlaneFree) {
  const Mesh sheet = open_sheet(2);
  SymmetryPlane plane{Vec3::UnitX(), 0, {}};
  for (const Vec3& p : sheet.positions) plane.is_on.push_back(p.x() == 0);
  const std::vector<Quadric> quadrics = surface_quadrics(sheet, {}, plane);
  EXPECT_NEAR(quadrics[3].at({0.2, 1, 0}), 0, 1e-12);
  EXPECT_GT(quadrics[5].at({1.8, 1, 0}), 0.01);
}

}  // namespace
}  // namespace foldwright::testing
