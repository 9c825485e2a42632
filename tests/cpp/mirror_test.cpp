#include "mesh/mirror.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "drawn_shapes.h"
#include "geometry/random.h"
#include "geometry/rigid_motion3.h"
#include "mesh/dual_graph.h"
#include "meshes.h"

namespace foldwright::testing {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

RigidMotion3 random_motion(Random& random) {
  const Eigen::Quaterniond r(random.normal(), random.normal(), random.normal(), random.normal());
  const Vec3 t(random.normal(), random.normal(), random.normal());
  return {r.normalized(), 5 * t};
}

Mesh moved(Mesh mesh, const RigidMotion3& motion) {
  for (Vec3& p : mesh.positions) p = motion(p);
  return mesh;
}

std::optional<Mirror> mirror_of(const Mesh& mesh) {
  return find_mirror(mesh, build_dual_graph(mesh).faces);
}

/// Angle between two planes with these unit normals, in degrees.
double degrees_between(const Vec3& a, const Vec3& b) {
  return std::asin(std::min(1.0, a.cross(b).norm())) / kDegree;
}

TEST(FindMirror, FindsThePlaneWhereverTheModelLies) {
  const Mesh mesh = bilateral(800);
  Random random(3);
  for (int i = 0; i < 10; ++i) {
    SCOPED_TRACE(i);
    const RigidMotion3 motion = random_motion(random);
    const auto mirror = mirror_of(moved(mesh, motion));
    ASSERT_TRUE(mirror);
    EXPECT_NEAR(mirror->normal.norm(), 1, 1e-12);
    EXPECT_LT(degrees_between(mirror->normal, motion.r * Vec3::UnitX()), 1);
    EXPECT_NEAR(mirror->normal.dot(motion.t), mirror->offset, 0.01);
    EXPECT_LT(mirror->error, 0.01);
  }
}

TEST(FindMirror, DoesNotDependOnTheSizeOfTheModel) {
  const Mesh mesh = bilateral(300);
  Mesh large = mesh;
  for (Vec3& p : large.positions) p *= 1024;  // rounds as the small one does
  const auto one = mirror_of(mesh);
  const auto other = mirror_of(large);
  ASSERT_TRUE(one && other);
  EXPECT_LT((one->normal - other->normal).norm(), 1e-6);
  EXPECT_NEAR(one->error, other->error, 1e-6);
}

TEST(FindMirror, BearsTheNoiseOfAScan) {
  Mesh mesh = bilateral(800);
  Random random(4);
  for (Vec3& p : mesh.positions) {
    p += 0.01 * Vec3(random.normal(), random.normal(), random.normal());
  }
  const auto mirror = mirror_of(mesh);
  ASSERT_TRUE(mirror);
  EXPECT_LT(degrees_between(mirror->normal, Vec3::UnitX()), 2);
}

TEST(FindMirror, FindsAPlaneWherePrincipalMomentsAreEqual) {
  // Two equal ones around an axis, or all three: principal axes say nothing there.
  const Mesh meshes[] = {cube(),     tetrahedron(), icosahedron(), star(),
                         dumbbell(), torus(24, 12), l_prism(),     moved(cube(), {})};
  Random random(5);
  for (const Mesh& mesh : meshes) {
    SCOPED_TRACE(mesh.face_count());
    for (int i = 0; i < 3; ++i) {
      const auto mirror = mirror_of(moved(mesh, random_motion(random)));
      ASSERT_TRUE(mirror);
      EXPECT_LT(mirror->error, 0.01);
    }
  }
}

TEST(FindMirror, FindsNoneWhereThereIsNone) {
  for (const Mesh& mesh : {random_hull(1, 12), random_hull(2, 14), random_hull(3, 16)}) {
    SCOPED_TRACE(mesh.face_count());
    EXPECT_FALSE(mirror_of(mesh));
  }
  Mesh screw = bilateral(800);  // turned about y by more, the higher up
  for (Vec3& p : screw.positions)
    p = Eigen::AngleAxisd(p.y(), Vec3::UnitY()) * Vec3(2 * p.x(), 2 * p.y(), p.z());
  EXPECT_FALSE(mirror_of(screw));
}

}  // namespace
}  // namespace foldwright::testing
