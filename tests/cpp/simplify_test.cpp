#include "simplify/simplify.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <ranges>

#include "drawn_shapes.h"
#include "face_crossings.h"
#include "geometry/triangle3.h"
#include "mesh/dual_graph.h"
#include "mesh/mirror.h"
#include "mesh/surface_tree.h"
#include "mesh_faults.h"
#include "meshes.h"

namespace foldwright::testing {
namespace {

TEST(Simplify, WorksAtAnyScale) {
  const Mesh usual = simplify(torus(24, 12), {.target_faces = 100});
  const auto at_scale = [](double scale) {
    Mesh fine = torus(24, 12);
    for (Vec3& p : fine.positions) p *= scale;
    return simplify(fine, {.target_faces = 100});
  };
  for (const int power : {-100, 100}) EXPECT_EQ(at_scale(std::exp2(power)).faces, usual.faces);
  // Rounding decides between edges that the torus has many of.
  for (const double scale : {1e-30, 1e30}) {
    const Mesh coarse = at_scale(scale);
    EXPECT_EQ(coarse.face_count(), usual.face_count());
    EXPECT_NEAR(area_of(coarse) / (scale * scale) / area_of(usual), 1, 0.03);
  }
}

/// The smallest angle of all faces, in degrees.
double sharpest_corner_of(const Mesh& mesh) {
  double least = 180;
  for (int f = 0; f < mesh.face_count(); ++f) {
    least = std::min(least, sharpest_corner(corners_of(mesh, f)));
  }
  return least;
}

TEST(Simplify, MakesNoSlivers) {
  EXPECT_GT(sharpest_corner_of(simplify(torus(96, 48), {.target_faces = 400})), 10);
  EXPECT_GT(sharpest_corner_of(simplify(bumpy_sphere(6000), {.target_faces = 500})), 10);
}

TEST(Simplify, KeepsFlatFacesFlatAndTheirEdgesSharp) {
  Mesh turned = grid_cube(12);
  const Eigen::Quaterniond turn = Eigen::Quaterniond(0.8, 0.3, -0.4, 0.2).normalized();
  for (Vec3& p : turned.positions) p = turn * p;
  for (const Mesh& fine : {grid_cube(12), turned}) {
    for (const int faces : {12, 40}) {
      const Mesh coarse = simplify(fine, {.target_faces = faces});
      EXPECT_EQ(coarse.face_count(), faces);
      EXPECT_EQ(build_dual_graph(coarse).panel_count(), 6);
      EXPECT_NEAR(signed_volume(coarse), signed_volume(fine), 1e-9);
    }
  }
}

TEST(Simplify, KeepsTheBorderBetweenRegions) {
  // A square of one colour in the middle of a sheet of another one.
  const Mesh fine = open_sheet(12);
  const auto is_inside = [](const Vec3& p) {
    return (p - Vec3(6, 6, 0)).lpNorm<Eigen::Infinity>() < 3;
  };
  std::vector<int> regions;
  for (int f = 0; f < fine.face_count(); ++f) {
    const Triangle3 t = corners_of(fine, f);
    regions.push_back(is_inside((t[0] + t[1] + t[2]) / 3));
  }
  const Mesh coarse = simplify(fine, {.target_faces = 30, .regions = regions});
  EXPECT_LE(coarse.face_count(), 30);
  double area = 0;
  for (int f = 0; f < coarse.face_count(); ++f) {
    const Triangle3 t = corners_of(coarse, f);
    if (is_inside((t[0] + t[1] + t[2]) / 3)) area += face_area(coarse, f);
  }
  EXPECT_NEAR(area, 36, 1e-6);
}

TEST(Simplify, KeepsASurfaceItsOwnMirrorImage) {
  const RigidMotion3 motion = {Eigen::Quaterniond(0.8, 0.3, -0.4, 0.2).normalized(), {3, 1, 2}};
  Mesh turned = bilateral(3000);
  for (Vec3& p : turned.positions) p = motion(p);
  Mesh half_open = open_sheet(12);
  for (Vec3& p : half_open.positions)
    p.z() = 0.02 * (p.x() - 6) * (p.x() - 6) + 0.1 * std::sin(p.y());
  for (const Mesh& fine : {turned, torus(48, 24), half_open, both(cube(), cube(), {4, 0, 0})}) {
    const Mesh coarse =
        simplify(fine, {.target_faces = fine.face_count() / 8, .keep_mirror = true});
    SCOPED_TRACE(fine.face_count());
    EXPECT_EQ(fault_of_centred(coarse), "");
    EXPECT_EQ(border_edge_count(coarse) > 0, border_edge_count(fine) > 0);
    EXPECT_EQ(coarse.component_count, fine.component_count);
    std::vector<int> all(fine.face_count());
    std::iota(all.begin(), all.end(), 0);
    const auto mirror = find_mirror(fine, all);  // a torus has many
    ASSERT_TRUE(mirror);
    const double unit = mean_edge_length(fine);
    for (const Vec3& p : coarse.positions) {
      const Vec3 image = mirror->image(p);
      EXPECT_TRUE(std::ranges::any_of(
          coarse.positions, [&](const Vec3& q) { return (q - image).norm() < 1e-3 * unit; }));
    }
  }
}

TEST(Simplify, LeavesWhatOneSideAloneHas) {
  // A spike on one side: a mirror image of the other side would lose it.
  Mesh fine = bilateral(3000);
  const auto tip =
      std::ranges::max_element(fine.positions, {}, [](const Vec3& p) { return p.x(); });
  *tip *= 1.5;
  const Vec3 spike = *tip;
  const Mesh coarse = simplify(fine, {.target_faces = 300, .keep_mirror = true});
  const auto distance = [&](const Vec3& p) { return (p - spike).norm(); };
  EXPECT_LT(std::ranges::min(coarse.positions | std::views::transform(distance)), 0.2);
}

TEST(Simplify, KeepsFacesFromRunningThroughOthers) {
  // Shells with little room between them.
  Mesh inner = bumpy_sphere(4000);
  for (Vec3& p : inner.positions) p *= 0.97;
  const Mesh shells = both(bumpy_sphere(4000), inner, Vec3::Zero());
  ASSERT_EQ(crossing_count(shells), 0);
  EXPECT_GT(crossing_count(simplify(shells, {.target_faces = 200})), 0);
  EXPECT_EQ(crossing_count(simplify(shells, {.target_faces = 200, .keep_apart = true})), 0);
}

}  // namespace
}  // namespace foldwright::testing
