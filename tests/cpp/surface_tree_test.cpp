#include "mesh/surface_tree.h"

#include <gtest/gtest.h>

#include "geometry/random.h"
#include "meshes.h"

namespace foldwright::testing {
namespace {

TEST(SurfaceTree, FindsTheNearestFaceWhateverIsGuessed) {
  const Mesh mesh = bumpy_sphere(400);
  const SurfaceTree surface(mesh);
  Random random(4);
  for (int i = 0; i < 200; ++i) {
    const Vec3 point = 2 * Vec3(random.normal(), random.normal(), random.normal());
    double least = surface.squared_distance(0, point);
    for (int face = 1; face < mesh.face_count(); ++face) {
      least = std::min(least, surface.squared_distance(face, point));
    }
    for (const int guess : {0, random.below(mesh.face_count())}) {
      EXPECT_EQ(surface.squared_distance(surface.nearest(point, guess), point), least);
    }
  }
}

TEST(SurfaceTree, KnowsItsFaces) {
  const Mesh mesh = cube();
  const SurfaceTree surface(mesh);
  for (int face = 0; face < mesh.face_count(); ++face) {
    const Vec3 middle =
        (surface.corners(face)[0] + surface.corners(face)[1] + surface.corners(face)[2]) / 3;
    EXPECT_NEAR(surface.normal(face).norm(), 1, 1e-15);
    EXPECT_GT(surface.normal(face).dot(middle), 0.49) << "out of the cube";
    EXPECT_EQ(surface.nearest(middle), face);
  }
}

}  // namespace
}  // namespace foldwright::testing
