// What `simplify` and `decimate` both promise.

#include <gtest/gtest.h>

#include <functional>
#include <ostream>

#include "mesh/decimate.h"
#include "mesh_faults.h"
#include "meshes.h"
#include "repair/repair.h"
#include "simplify/simplify.h"

namespace foldwright::testing {
namespace {

struct Way {
  const char* name;
  std::function<Mesh(const Mesh&, int)> make;
};

void PrintTo(const Way& way, std::ostream* out) { *out << way.name; }

class FewerFaces : public ::testing::TestWithParam<Way> {};

TEST_P(FewerFaces, ReturnsSmallMeshesAsTheyAre) {
  EXPECT_EQ(GetParam().make(cube(), 12).faces, cube().faces);
}

TEST_P(FewerFaces, KeepsAClosedSurfaceClosedAndItsShape) {
  const Mesh fine = torus(48, 24);
  const Mesh coarse = GetParam().make(fine, 400);
  EXPECT_EQ(fault_of_centred(coarse), "");
  EXPECT_EQ(border_edge_count(coarse), 0);
  EXPECT_LE(coarse.face_count(), 400);
  EXPECT_GE(coarse.face_count(), 396);
  EXPECT_EQ(coarse.vertex_count() - coarse.edge_count() + coarse.face_count(), 0);  // still a torus
  EXPECT_NEAR(signed_volume(coarse) / signed_volume(fine), 1, 0.1);
}

TEST_P(FewerFaces, KeepsEveryComponent) {
  PolygonSoup two = soup_of(torus(24, 12));
  const Mesh small = cube();
  for (const Vec3& p : small.positions) two.positions.push_back(p * 0.01 + Vec3(0, 0, 5));
  for (const auto& face : small.faces) {
    for (const int vertex : face) two.corners.push_back(vertex + 24 * 12);
    two.first_corner.push_back(static_cast<int>(two.corners.size()));
  }
  const Mesh coarse = GetParam().make(repair(two).mesh, 40);
  EXPECT_EQ(coarse.component_count, 2);
  EXPECT_EQ(border_edge_count(coarse), 0);
}

TEST_P(FewerFaces, KeepsTheCornersOfABorder) {
  const Mesh coarse = GetParam().make(open_sheet(12), 20);
  EXPECT_LE(coarse.face_count(), 20);
  EXPECT_NEAR(area_of(coarse), 144, 1e-9);
  EXPECT_EQ(fault_of_centred(coarse), "");
}

TEST_P(FewerFaces, SaysMoreFacesWhenItCannotGoOn) {
  EXPECT_EQ(GetParam().make(tetrahedron(), 2).face_count(), 4);
}

TEST_P(FewerFaces, CarriesTheSourceOfTheNearestFace) {
  Mesh fine = torus(48, 24);
  for (int& source : fine.source_faces) source += 1000;
  const Mesh coarse = GetParam().make(fine, 300);
  for (int f = 0; f < coarse.face_count(); ++f) {
    const int source = coarse.source_faces[f] - 1000;
    ASSERT_GE(source, 0);
    ASSERT_LT(source, fine.face_count());
    const Vec3 here = coarse.positions[coarse.faces[f][0]];
    const Vec3 there = fine.positions[fine.faces[source][0]];
    EXPECT_LT((here - there).norm(), 0.7);  // a coarse edge is about that long
  }
}

INSTANTIATE_TEST_SUITE_P(BothWays, FewerFaces,
                         ::testing::Values(Way{"Simplify",
                                               [](const Mesh& mesh, int faces) {
                                                 return simplify(mesh, {.target_faces = faces});
                                               }},
                                           Way{"Decimate", decimate}),
                         [](const auto& way) { return way.param.name; });

}  // namespace
}  // namespace foldwright::testing
