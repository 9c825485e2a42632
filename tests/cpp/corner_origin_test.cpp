#include "mesh/corner_origin.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "mesh_faults.h"
#include "meshes.h"
#include "repair/repair.h"
#include "repair/split_nonmanifold.h"

namespace foldwright::testing {
namespace {

/// A square of side 2 in one polygon that begins in its corner (2, 0).
PolygonSoup square() { return soup({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}}, {{1, 2, 3, 0}}); }

bool is_corner(const CornerOrigin& origin) { return origin.weights.maxCoeff() == 1; }

/// Corners that come from one of the file's own, and not from between them.
int own_corners(const RepairedModel& model) {
  int count = 0;
  for (const FaceOrigins& face : model.origins) count += std::ranges::count_if(face, is_corner);
  return count;
}

TEST(CornerOrigin, OfATriangleAreItsCorners) {
  const FaceOrigins origins = origins_of_triangle(0, {0, 1, 3});
  EXPECT_EQ(position_at(square(), origins[0]), Vec3(2, 0, 0));
  EXPECT_EQ(position_at(square(), origins[1]), Vec3(2, 2, 0));
  EXPECT_EQ(position_at(square(), origins[2]), Vec3(0, 0, 0));
}

TEST(CornerOrigin, GoesFromOnePlaceToAnother) {
  const FaceOrigins origins = origins_of_triangle(0, {0, 1, 3});
  const CornerOrigin quarter = place_between(origins[0], origins[1], 0.25);
  EXPECT_EQ(position_at(square(), quarter), Vec3(2, 0.5, 0));
  EXPECT_EQ(position_at(square(), place_between(quarter, origins[2], 0.5)), Vec3(1, 0.25, 0));
}

TEST(CornerOrigin, IsAPlaceWithinATriangle) {
  const FaceOrigins whole = origins_of_triangle(0, {0, 1, 3});
  const FaceOrigins half = {whole[0], whole[1], place_between(whole[0], whole[2], 0.5)};
  EXPECT_EQ(position_at(square(), place_within(half, {0.25, 0.25, 0.5})), Vec3(1.5, 0.5, 0));
  // Rounding leaves no place outside.
  EXPECT_EQ(place_within(whole, {1 + 1e-16, -1e-16, 0}).weights, Vec3::UnitX());
}

TEST(CornerOrigin, OfRepairedPolygonsAreTheirCorners) {
  const RepairedModel model = repair(square());
  EXPECT_EQ(origin_fault_of(square(), model), "");
  EXPECT_EQ(own_corners(model), 6);
}

TEST(CornerOrigin, OutlivesRepeatedCornersOfAPolygon) {
  // The second corner is given twice, and from the fourth a spike goes out and back.
  const PolygonSoup spoilt =
      soup({{0, 0, 0}, {2, 0, 0}, {2, 0, 0}, {2, 2, 0}, {5, 5, 0}, {2, 2, 0}, {0, 2, 0}},
           {{0, 1, 2, 3, 4, 5, 6}});
  const RepairedModel model = repair(spoilt);
  EXPECT_EQ(model.mesh.face_count(), 2);
  EXPECT_EQ(origin_fault_of(spoilt, model), "");
}

TEST(CornerOrigin, LiesOnTheEdgeWhereAnotherFaceHasItsCorner) {
  // Below the square's edge from (0, 0) to (2, 0) two triangles meet at a quarter of it.
  PolygonSoup sheet = soup({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0.5, 0, 0}, {1, -1, 0}},
                           {{0, 1, 2, 3}, {0, 5, 4}, {4, 5, 1}});
  const RepairedModel model = repair(sheet);
  EXPECT_EQ(origin_fault_of(sheet, model), "");
  EXPECT_EQ(model.mesh.face_count(), 5);
  int between = 0;
  for (int f = 0; f < model.mesh.face_count(); ++f) {
    for (const CornerOrigin& origin : model.origins[f]) {
      if (is_corner(origin)) continue;
      ++between;
      EXPECT_EQ(origin.face, 0) << "the triangles have a corner of their own there";
      EXPECT_EQ(position_at(sheet, origin), Vec3(0.5, 0, 0));
      EXPECT_EQ(origin.weights.maxCoeff(), 0.75);
    }
  }
  EXPECT_EQ(between, 2) << "one in each of the two faces that the square's triangle became";
}

TEST(CornerOrigin, StaysTheCornerWhereVerticesAreMoved) {
  // Two squares with a crack of a thousandth between them, in a sheet of 4 by 2.
  const PolygonSoup cracked = soup({{0, 0, 0},
                                    {2, 0, 0},
                                    {2, 2, 0},
                                    {0, 2, 0},
                                    {2.001, 0, 0},
                                    {4, 0, 0},
                                    {4, 2, 0},
                                    {2.001, 2, 0}},
                                   {{0, 1, 2, 3}, {4, 5, 6, 7}});
  const RepairedModel model = repair(cracked);
  EXPECT_EQ(border_edge_count(model.mesh), 6);
  EXPECT_EQ(own_corners(model), 12);
  EXPECT_EQ(origin_fault_of(cracked, model), "");
  EXPECT_NEAR(model.largest_move, 0.5e-3, 1e-9);
}

TEST(CornerOrigin, IsInTheMiddleOfAHalvedEdge) {
  // A square and its back, both cut along the same diagonal: one of the two diagonals is halved.
  const std::array<std::array<int, 3>, 4> faces = {{{0, 1, 2}, {0, 2, 3}, {0, 2, 1}, {0, 3, 2}}};
  TriangleSoup sheet{.positions = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}},
                     .faces = {faces.begin(), faces.end()},
                     .source_faces = {0, 0, 1, 1},
                     .errors = {},
                     .origins = {}};
  for (int f = 0; f < 4; ++f) sheet.origins.push_back(origins_of_triangle(f / 2, faces[f]));
  const Partners partners = {8, 7, 3, 2, 10, 9, 11, 1, 0, 5, 4, 6};
  EXPECT_EQ(split_nonmanifold(sheet, partners).midpoints, 1);
  EXPECT_EQ(sheet.face_count(), 6);
  const PolygonSoup file =
      soup({sheet.positions.begin(), sheet.positions.begin() + 4}, {{0, 1, 2, 3}, {0, 1, 2, 3}});
  for (int f = 0; f < sheet.face_count(); ++f) {
    for (int i = 0; i < 3; ++i) {
      EXPECT_EQ(sheet.origins[f][i].face, sheet.source_faces[f]);
      EXPECT_EQ(position_at(file, sheet.origins[f][i]), sheet.positions[sheet.faces[f][i]]);
    }
  }
}

TEST(CornerOrigin, FollowsCornersOfTurnedFaces) {
  PolygonSoup turned = soup_of(star());
  std::swap(turned.corners[0], turned.corners[1]);
  const RepairedModel model = repair(turned);
  EXPECT_EQ(origin_fault_of(turned, model), "");
  EXPECT_EQ(model.largest_move, 0);
}

}  // namespace
}  // namespace foldwright::testing
