#include "mesh/simplify.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mesh_faults.h"
#include "meshes.h"
#include "repair/repair.h"

namespace foldwright::testing {
namespace {

double area_of(const Mesh& mesh) {
  double sum = 0;
  for (int f = 0; f < mesh.face_count(); ++f) sum += face_area(mesh, f);
  return sum;
}

/// A mesh may be off-centre after simplification; all else has to be as after a repair.
std::string fault_of_centred(Mesh mesh) {
  Eigen::AlignedBox3d box;
  for (const Vec3& p : mesh.positions) box.extend(p);
  for (Vec3& p : mesh.positions) p -= box.center();
  return fault_of(mesh);
}

/// Flat square sheet of `side` x `side` squares, open.
Mesh sheet(int side) {
  std::vector<Vec3> positions;
  std::vector<std::array<int, 3>> faces;
  for (int y = 0; y <= side; ++y) {
    for (int x = 0; x <= side; ++x) positions.emplace_back(x, y, 0);
  }
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const int a = y * (side + 1) + x;
      const int b = a + side + 1;
      faces.insert(faces.end(), {{a, a + 1, b + 1}, {a, b + 1, b}});
    }
  }
  return make_mesh(std::move(positions), std::move(faces));
}

TEST(Simplify, ReturnsSmallMeshesAsTheyAre) {
  EXPECT_EQ(simplify(cube(), {.target_faces = 12}).faces, cube().faces);
}

TEST(Simplify, KeepsAClosedSurfaceClosedAndItsShape) {
  const Mesh fine = torus(48, 24);
  const Mesh coarse = simplify(fine, {.target_faces = 400});
  EXPECT_EQ(fault_of_centred(coarse), "");
  EXPECT_EQ(border_edge_count(coarse), 0);
  EXPECT_LE(coarse.face_count(), 400);
  EXPECT_GE(coarse.face_count(), 396);
  EXPECT_EQ(coarse.vertex_count() - coarse.edge_count() + coarse.face_count(), 0);  // still a torus
  EXPECT_NEAR(signed_volume(coarse) / signed_volume(fine), 1, 0.1);
}

TEST(Simplify, WorksAtAnyScale) {
  for (const double scale : {1e-30, 1e30}) {
    Mesh fine = torus(24, 12);
    for (Vec3& p : fine.positions) p *= scale;
    EXPECT_EQ(simplify(fine, {.target_faces = 100}).faces,
              simplify(torus(24, 12), {.target_faces = 100}).faces);
  }
}

TEST(Simplify, KeepsEveryComponent) {
  PolygonSoup two = soup_of(torus(24, 12));
  const Mesh small = cube();
  for (const Vec3& p : small.positions) two.positions.push_back(p * 0.01 + Vec3(0, 0, 5));
  for (const auto& face : small.faces) {
    for (const int vertex : face) two.corners.push_back(vertex + 24 * 12);
    two.first_corner.push_back(static_cast<int>(two.corners.size()));
  }
  const Mesh coarse = simplify(repair(two).mesh, {.target_faces = 40});
  EXPECT_EQ(coarse.component_count, 2);
  EXPECT_EQ(border_edge_count(coarse), 0);
}

TEST(Simplify, KeepsTheCornersOfABorder) {
  const Mesh coarse = simplify(sheet(12), {.target_faces = 20});
  EXPECT_LE(coarse.face_count(), 20);
  EXPECT_NEAR(area_of(coarse), 144, 1e-9);
  EXPECT_EQ(fault_of_centred(coarse), "");
}

TEST(Simplify, SaysMoreFacesWhenItCannotGoOn) {
  EXPECT_EQ(simplify(tetrahedron(), {.target_faces = 2}).face_count(), 4);
}

TEST(Simplify, CarriesTheSourceOfTheNearestFace) {
  Mesh fine = torus(48, 24);
  for (int& source : fine.source_faces) source += 1000;
  const Mesh coarse = simplify(fine, {.target_faces = 300});
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
