#include "mesh/decimate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mesh_faults.h"
#include "meshes.h"
#include "repair/repair.h"

namespace foldwright::testing {
namespace {

TEST(Decimate, ReturnsSmallMeshesAsTheyAre) { EXPECT_EQ(decimate(cube(), 12).faces, cube().faces); }

TEST(Decimate, KeepsAClosedSurfaceClosedAndItsShape) {
  const Mesh fine = torus(48, 24);
  const Mesh coarse = decimate(fine, 400);
  EXPECT_EQ(fault_of_centred(coarse), "");
  EXPECT_EQ(border_edge_count(coarse), 0);
  EXPECT_LE(coarse.face_count(), 400);
  EXPECT_GE(coarse.face_count(), 396);
  EXPECT_EQ(coarse.vertex_count() - coarse.edge_count() + coarse.face_count(), 0);  // still a torus
  EXPECT_NEAR(signed_volume(coarse) / signed_volume(fine), 1, 0.1);
}

TEST(Decimate, WorksAtAnyScale) {
  for (const double scale : {1e-30, 1e30}) {
    Mesh fine = torus(24, 12);
    for (Vec3& p : fine.positions) p *= scale;
    EXPECT_EQ(decimate(fine, 100).faces, decimate(torus(24, 12), 100).faces);
  }
}

TEST(Decimate, KeepsEveryComponent) {
  PolygonSoup two = soup_of(torus(24, 12));
  const Mesh small = cube();
  for (const Vec3& p : small.positions) two.positions.push_back(p * 0.01 + Vec3(0, 0, 5));
  for (const auto& face : small.faces) {
    for (const int vertex : face) two.corners.push_back(vertex + 24 * 12);
    two.first_corner.push_back(static_cast<int>(two.corners.size()));
  }
  const Mesh coarse = decimate(repair(two).mesh, 40);
  EXPECT_EQ(coarse.component_count, 2);
  EXPECT_EQ(border_edge_count(coarse), 0);
}

TEST(Decimate, KeepsTheCornersOfABorder) {
  const Mesh coarse = decimate(open_sheet(12), 20);
  EXPECT_LE(coarse.face_count(), 20);
  EXPECT_NEAR(area_of(coarse), 144, 1e-9);
  EXPECT_EQ(fault_of_centred(coarse), "");
}

TEST(Decimate, SaysMoreFacesWhenItCannotGoOn) {
  EXPECT_EQ(decimate(tetrahedron(), 2).face_count(), 4);
}

TEST(Decimate, CarriesTheSourceOfTheNearestFace) {
  Mesh fine = torus(48, 24);
  for (int& source : fine.source_faces) source += 1000;
  const Mesh coarse = decimate(fine, 300);
  for (int f = 0; f < coarse.face_count(); ++f) {
    const int source = coarse.source_faces[f] - 1000;
    ASSERT_GE(source, 0);
    ASSERT_LT(source, fine.face_count());
    const Vec3 here = coarse.positions[coarse.faces[f][0]];
    const Vec3 there = fine.positions[fine.faces[source][0]];
    EXPECT_LT((here - there).norm(), 0.7);  // a coarse edge is about that long
  }
}

}  // namespace
}  // namespace foldwright::testing
