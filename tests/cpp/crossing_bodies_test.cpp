#include "repair/crossing_bodies.h"

#include <gtest/gtest.h>

#include "drawn_shapes.h"
#include "face_crossings.h"
#include "meshes.h"

namespace foldwright::testing {
namespace {

Crossings crossings_of(const Mesh& mesh) {
  return find_crossings({.positions = mesh.positions, .faces = mesh.faces, .source_faces = {}},
                        mesh.components);
}

TEST(CrossingBodies, CountsPairsThatRunThroughEachOther) {
  EXPECT_EQ(crossings_of(both(cube(), cube(), {0.5, 0.4, 0.3})).pairs.size(), 1u);
  EXPECT_EQ(crossings_of(both(torus(12, 8), torus(12, 8), {0.3, 0.2, 0.1})).pairs.size(), 1u);
  // A bar through two opposite faces of the cube, none of whose corners lies inside.
  Mesh bar = cube();
  for (Vec3& p : bar.positions) p = p.cwiseProduct(Vec3(0.3, 0.3, 4));
  EXPECT_EQ(crossings_of(both(cube(), bar, Vec3::Zero())).pairs.size(), 1u);
}

TEST(CrossingBodies, LeavesBodiesThatTouchOrContainEachOther) {
  for (const Vec3& shift : {Vec3(1, 0, 0), Vec3(1, 0.3, 0.4), Vec3(1, 1, 0), Vec3(1, 1, 1),
                            Vec3(1, 1, 0.5), Vec3(3, 0, 0)}) {
    EXPECT_EQ(crossings_of(both(cube(), cube(), shift)).pairs.size(), 0u) << shift.transpose();
  }
  Mesh inner = cube();
  for (Vec3& p : inner.positions) p *= 0.5;
  EXPECT_EQ(crossings_of(both(cube(), inner, Vec3::Zero())).pairs.size(), 0u);
}

TEST(CrossingBodies, CountsBodiesThatRunThroughThemselves) {
  EXPECT_EQ(crossings_of(crossing_strip()).bodies.size(), 1u);
  for (const Mesh& mesh : {cube(), star(), torus(8, 6), l_prism(), dumbbell(), bumpy_sphere(500)}) {
    EXPECT_EQ(crossings_of(mesh).bodies.size(), 0u);
  }
}

}  // namespace
}  // namespace foldwright::testing
