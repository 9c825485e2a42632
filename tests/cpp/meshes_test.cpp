#include "meshes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "drawn_shapes.h"

namespace foldwright::testing {
namespace {

void expect_closed(const Mesh& mesh, int faces, int euler_characteristic) {
  EXPECT_EQ(mesh.face_count(), faces);
  EXPECT_EQ(mesh.component_count, 1);
  EXPECT_EQ(border_edge_count(mesh), 0);
  EXPECT_EQ(mesh.vertex_count() - mesh.edge_count() + mesh.face_count(), euler_characteristic);
  EXPECT_GT(signed_volume(mesh), 0);
}

TEST(Meshes, ClosedOnesAreClosedAndWoundOutwards) {
  expect_closed(cube(), 12, 2);
  expect_closed(tetrahedron(), 4, 2);
  expect_closed(icosahedron(), 20, 2);
  expect_closed(star(), 60, 2);
  expect_closed(torus(8, 6), 96, 0);
  expect_closed(pretzel(), 100, -2);
  expect_closed(l_prism(), 20, 2);
  expect_closed(dumbbell(), 336, 2);
  expect_closed(bumpy_sphere(1000), 1024, 2);
}

TEST(Meshes, HullOfPointsOnASphereUsesThemAll) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    expect_closed(random_hull(seed, 40), 76, 2);
  }
}

TEST(Meshes, StripIsOpen) {
  const Mesh strip = open_strip(5);
  EXPECT_EQ(strip.face_count(), 10);
  EXPECT_EQ(border_edge_count(strip), 12);
}

TEST(Meshes, SaddleHasTheTurnAskedFor) {
  const Mesh mesh = saddle(8, 7);
  double turn = 0;
  for (const auto& [apex, a, b] : mesh.faces) {
    turn += std::acos(mesh.positions[a].normalized().dot(mesh.positions[b].normalized()));
  }
  EXPECT_NEAR(turn, 7, 1e-12);
  EXPECT_EQ(border_edge_count(mesh), 8);
}

}  // namespace
}  // namespace foldwright::testing
