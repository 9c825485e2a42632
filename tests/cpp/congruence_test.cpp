#include "unfold/congruence.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "geometry/random.h"
#include "meshes.h"
#include "unfold/layout.h"

namespace foldwright::testing {
namespace {

/// Two copies of a mesh in one: the second one moved, and its faces in another order.
struct TwoBodies {
  Mesh mesh;
  DualGraph first, second;
};

DualGraph graph_of_faces(const DualGraph& whole, int from, int to) {
  std::vector<int> panels;
  for (int panel = 0; panel < whole.panel_count(); ++panel) {
    const int face = whole.panel_faces(panel)[0];
    if (face >= from && face < to) panels.push_back(panel);
  }
  return restrict_to(whole, panels);
}

template <class Move>
TwoBodies two_bodies(const Mesh& mesh, Move&& move, bool is_mirrored) {
  std::vector<Vec3> positions = mesh.positions;
  for (const Vec3& p : mesh.positions) positions.push_back(move(p));
  std::vector<std::array<int, 3>> faces = mesh.faces;
  for (int f = mesh.face_count() - 1; f >= 0; --f) {
    auto [a, b, c] = mesh.faces[f];
    if (is_mirrored) std::swap(b, c);
    const int shift = mesh.vertex_count();
    faces.push_back({b + shift, c + shift, a + shift});
  }
  TwoBodies bodies{make_mesh(positions, faces), {}, {}};
  const DualGraph whole = build_dual_graph(bodies.mesh);
  bodies.first = graph_of_faces(whole, 0, mesh.face_count());
  bodies.second = graph_of_faces(whole, mesh.face_count(), 2 * mesh.face_count());
  return bodies;
}

/// Panels and hinges go to different ones, hinges to those between the panels of theirs, and to as
/// long and as much folded ones.
void expect_congruence(const TwoBodies& bodies, const Congruence& congruence) {
  const auto count_of = [](const std::vector<int>& v) {
    return std::set(v.begin(), v.end()).size();
  };
  ASSERT_EQ(count_of(congruence.panels), bodies.second.areas.size());
  ASSERT_EQ(count_of(congruence.hinges), bodies.second.hinges.size());
  for (int h = 0; h < bodies.first.hinge_count(); ++h) {
    const Hinge& from = bodies.first.hinges[h];
    const Hinge& to = bodies.second.hinges[congruence.hinges[h]];
    EXPECT_NEAR(from.length, to.length, 1e-3);
    EXPECT_NEAR(from.angle, to.angle, 1e-2);
    const std::set<int> panels(to.panels.begin(), to.panels.end());
    for (const int panel : from.panels) EXPECT_TRUE(panels.contains(congruence.panels[panel]));
  }
}

Vec3 turned(const Vec3& p) {
  const Eigen::AngleAxisd turn(2.1, Vec3(1, -2, 0.5).normalized());
  return turn * p + Vec3(7, -3, 11);
}

TEST(Congruence, IsFoundAfterATurnAndAShift) {
  for (const Mesh& mesh : {random_hull(3, 30), star(), pretzel(), torus(9, 5), bumpy_sphere(300)}) {
    SCOPED_TRACE(mesh.face_count());
    const TwoBodies bodies = two_bodies(mesh, turned, false);
    const auto congruence = find_congruence(bodies.mesh, bodies.first, bodies.second);
    ASSERT_TRUE(congruence);
    EXPECT_FALSE(congruence->is_mirrored);
    EXPECT_LT(congruence->error, 1e-9);
    expect_congruence(bodies, *congruence);
  }
}

TEST(Congruence, IsFoundInAMirror) {
  for (const Mesh& mesh : {random_hull(3, 30), bumpy_sphere(300)}) {
    SCOPED_TRACE(mesh.face_count());
    const auto mirrored = [](const Vec3& p) { return turned(Vec3(-p.x(), p.y(), p.z())); };
    const TwoBodies bodies = two_bodies(mesh, mirrored, true);
    const auto congruence = find_congruence(bodies.mesh, bodies.first, bodies.second);
    ASSERT_TRUE(congruence);
    EXPECT_TRUE(congruence->is_mirrored);
    expect_congruence(bodies, *congruence);
  }
}

TEST(Congruence, IsFoundWhereCoordinatesAreRounded) {
  const auto rounded = [](const Vec3& p) -> Vec3 {
    return (turned(p) * 1e5).array().round().matrix() / 1e5;
  };
  const TwoBodies bodies = two_bodies(bumpy_sphere(300), rounded, false);
  const auto congruence = find_congruence(bodies.mesh, bodies.first, bodies.second);
  ASSERT_TRUE(congruence);
  EXPECT_GT(congruence->error, 1e-7);
  expect_congruence(bodies, *congruence);
}

TEST(Congruence, IsNotFoundWhereOneCornerDiffers) {
  const Mesh mesh = bumpy_sphere(300);
  int left = mesh.vertex_count() / 2;
  const auto dented = [&](const Vec3& p) -> Vec3 { return turned(left-- == 0 ? 0.97 * p : p); };
  const TwoBodies bodies = two_bodies(mesh, dented, false);
  EXPECT_FALSE(find_congruence(bodies.mesh, bodies.first, bodies.second));
}

TEST(Congruence, CarriesTreesToNetsOfTheSameShape) {
  const TwoBodies bodies = two_bodies(random_hull(5, 40), turned, false);
  const auto congruence = find_congruence(bodies.mesh, bodies.first, bodies.second);
  ASSERT_TRUE(congruence);
  std::vector<double> weights(bodies.first.hinge_count());
  Random random(11);
  for (double& weight : weights) weight = random.uniform();
  const FoldTree folds = minimum_spanning_tree(bodies.first, weights);
  FoldTree carried;
  for (const int fold : folds) carried.push_back(congruence->hinges[fold]);
  std::ranges::sort(carried);
  const auto overlaps = [](const DualGraph& graph, const FoldTree& tree) {
    return overlapping_panels(graph, lay_out(graph, hang_tree(graph, tree))).size();
  };
  EXPECT_EQ(overlaps(bodies.first, folds), overlaps(bodies.second, carried));
}

}  // namespace
}  // namespace foldwright::testing
