#include "simplify/mirror_half.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "meshes.h"

namespace foldwright::testing {
namespace {

const Mirror kAcrossX = {Vec3::UnitX(), 0, 0};

Mesh put_together(const MirrorHalf& half) {
  return with_image({half.mesh.positions, half.mesh.faces, half.plane.is_on}, half.plane);
}

TEST(MirrorHalf, TellsWhatMirrorsItself) {
  EXPECT_TRUE(mirrors_itself(cube(), kAcrossX));
  EXPECT_TRUE(mirrors_itself(torus(24, 12), kAcrossX));
  EXPECT_FALSE(mirrors_itself(cube(), {Vec3::UnitX(), 0.1, 0}));
  Mesh spiked = torus(24, 12);
  spiked.positions[0] *= 1.1;
  EXPECT_FALSE(mirrors_itself(spiked, kAcrossX));
}

TEST(MirrorHalf, IsTheSurfaceAgainWithItsImage) {
  Mesh skewed = torus(25, 12);  // the plane cuts faces
  for (Vec3& p : skewed.positions) p.x() *= 1.3;
  for (const Mesh& whole : {cube(), torus(24, 12), skewed, tetrahedron()}) {
    const auto half = half_in_front(whole, kAcrossX);
    ASSERT_TRUE(half);
    for (const Vec3& p : half->mesh.positions) EXPECT_GE(p.x(), 0);
    const Mesh again = put_together(*half);
    EXPECT_EQ(border_edge_count(again), 0);
    EXPECT_EQ(again.component_count, 1);
    EXPECT_NEAR(signed_volume(again) / signed_volume(whole), 1, 0.02);
  }
}

TEST(MirrorHalf, KeepsHolesOpen) {
  const Mesh strip = open_strip(4);
  const auto half = half_in_front(strip, {Vec3::UnitX(), strip.positions[0].x() + 2, 0});
  ASSERT_TRUE(half);
  const Mesh again = put_together(*half);
  EXPECT_EQ(again.face_count(), strip.face_count());
  EXPECT_EQ(border_edge_count(again), border_edge_count(strip));
}

TEST(MirrorHalf, NamesTheFacesThatItWasCutFrom) {
  const Mesh whole = torus(25, 12);
  const auto half = half_in_front(whole, kAcrossX);
  ASSERT_TRUE(half);
  for (int f = 0; f < half->mesh.face_count(); ++f) {
    const int source = half->mesh.source_faces[f];
    ASSERT_LT(source, whole.face_count());
    const double highest =
        std::ranges::max(whole.faces[source], {}, [&](int v) { return whole.positions[v].x(); });
    EXPECT_GT(highest, -1);
  }
}

TEST(MirrorHalf, IsNoneWhereAFaceLiesInThePlane) {
  EXPECT_FALSE(half_in_front(cube(), {Vec3::UnitX(), 0.5, 0}));
}

}  // namespace
}  // namespace foldwright::testing
