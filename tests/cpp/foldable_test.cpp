#include "fold/foldable.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "drawn_shapes.h"
#include "folding.h"
#include "meshes.h"
#include "trees.h"
#include "unfold/layout.h"

namespace foldwright::testing {
namespace {

// Nothing about a panel of several faces is looser: those here are flat to rounding.
constexpr double kSameShape = 1e-9;

std::vector<Mesh> ordinary_meshes() {
  return {cube(),
          tetrahedron(),
          star(),
          torus(8, 6),
          l_prism(),
          random_hull(1, 12),
          random_hull(2, 40),
          bumpy_sphere(120),
          open_strip(3),
          accordion({1, 2, 1, 3}),
          saddle(8, 7)};
}

/// Faces of the graph as they are in the model.
std::vector<Triangle3> model_faces(const Mesh& mesh, const DualGraph& graph) {
  std::vector<Triangle3> faces;
  for (const int face : graph.faces) {
    const auto& [a, b, c] = mesh.faces[face];
    faces.push_back({mesh.positions[a], mesh.positions[b], mesh.positions[c]});
  }
  return faces;
}

/// Faces of the graph in a layout, not eroded.
std::vector<Triangle3> laid_faces(const DualGraph& graph, const FoldedLayout& layout) {
  std::vector<Triangle3> faces;
  for (int panel = 0; panel < graph.panel_count(); ++panel) {
    for (const Triangle2& t : graph.panel_triangles(panel)) {
      faces.push_back(moved(layout[panel], t));
    }
  }
  return faces;
}

/// Greatest difference of a distance between two corners, relative to the model's size.
double distortion(const std::vector<Triangle3>& a, const std::vector<Triangle3>& b) {
  double size = 0;
  double most = 0;
  for (std::size_t i = 0; i < 3 * a.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      const double in_a = (a[i / 3][i % 3] - a[k / 3][k % 3]).norm();
      const double in_b = (b[i / 3][i % 3] - b[k / 3][k % 3]).norm();
      size = std::max(size, in_a);
      most = std::max(most, std::abs(in_a - in_b));
    }
  }
  return most / size;
}

/// Volume of the tetrahedra from the origin: its sign tells a shape from its mirror image.
double signed_volume(const std::vector<Triangle3>& faces) {
  double sum = 0;
  for (const Triangle3& t : faces) sum += t[0].dot(t[1].cross(t[2]));
  return sum / 6;
}

TEST(FoldUp, BringsTheShapeOfTheModelBack) {
  for (const Mesh& mesh : ordinary_meshes()) {
    SCOPED_TRACE(mesh.face_count());
    const DualGraph graph = build_dual_graph(mesh);
    const Foldable foldable = make_foldable(graph);
    const auto expected = model_faces(mesh, graph);
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      SCOPED_TRACE(seed);
      Random random(seed);
      const int root = random.below(graph.panel_count());
      const RootedTree tree = hang_tree(graph, random_tree(graph, random), root);
      const auto folded = laid_faces(graph, fold_up(foldable, tree, fold_angles(graph, 1)));
      EXPECT_LT(distortion(expected, folded), kSameShape);
      if (border_edge_count(mesh) == 0) {
        const double volume = signed_volume(expected);
        EXPECT_NEAR(signed_volume(folded), volume, 1e-8 * (1 + std::abs(volume)));
      }
    }
  }
}

TEST(FoldUp, BringsPanelsBackAsFlatAsTheyAre) {
  // A panel whose faces are not quite in one plane is laid flat, so that its shape comes back no
  // better than that: a lid with a corner moved by a millionth.
  Mesh mesh = cube();
  mesh.positions[7] *= 1 + 1e-6;
  mesh = make_mesh(mesh.positions, mesh.faces);
  const DualGraph graph = build_dual_graph(mesh);
  ASSERT_EQ(graph.panel_count(), 6);
  const Foldable foldable = make_foldable(graph);
  for (const FoldTree& folds : all_spanning_trees(graph)) {
    const auto layout = fold_up(foldable, hang_tree(graph, folds), fold_angles(graph, 1));
    EXPECT_LT(distortion(model_faces(mesh, graph), laid_faces(graph, layout)), 1e-5);
  }
}

TEST(FoldUp, LeavesANetFlatAtShareZero) {
  for (const Mesh& mesh : ordinary_meshes()) {
    SCOPED_TRACE(mesh.face_count());
    const DualGraph graph = build_dual_graph(mesh);
    const Foldable foldable = make_foldable(graph);
    Random random(1);
    const RootedTree tree = hang_tree(graph, random_tree(graph, random));
    const FoldedLayout folded = fold_up(foldable, tree, fold_angles(graph, 0));
    const Layout flat = lay_out(graph, tree);
    for (int panel = 0; panel < graph.panel_count(); ++panel) {
      for (const Triangle2& t : graph.panel_triangles(panel)) {
        const Triangle3 in_space = moved(folded[panel], t);
        const Triangle2 in_plane = moved(flat[panel], t);
        for (int i = 0; i < 3; ++i) {
          EXPECT_LT(std::abs(in_space[i].z()), 1e-12);
          EXPECT_LT((in_space[i].head<2>() - in_plane[i]).norm(), 1e-10);
        }
      }
    }
  }
}

TEST(FoldUp, KeepsTheRootInThePlane) {
  const DualGraph graph = build_dual_graph(star());
  const Foldable foldable = make_foldable(graph);
  Random random(2);
  const FoldTree folds = random_tree(graph, random);
  for (const int root : {0, 17, 59}) {
    const FoldedLayout layout =
        fold_up(foldable, hang_tree(graph, folds, root), fold_angles(graph, 0.4));
    const Vec3 p(1, 2, 0);
    EXPECT_EQ(layout[root](p), p);
  }
}

TEST(FoldUp, GivesWhatRodriguesFormulaGives) {
  for (const Mesh& mesh : ordinary_meshes()) {
    SCOPED_TRACE(mesh.face_count());
    const DualGraph graph = build_dual_graph(mesh);
    const Foldable foldable = make_foldable(graph);
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      SCOPED_TRACE(seed);
      Random random(seed);
      const FoldTree folds = random_tree(graph, random);
      const PlainFolder folder(mesh, graph, folds);
      std::vector<double> angles;
      for (int h = 0; h < graph.hinge_count(); ++h) angles.push_back(6 * random.uniform() - 3);
      const FoldedLayout layout = fold_up(foldable, hang_tree(graph, folds), angles);
      EXPECT_LT(distortion(folder.faces(angles), laid_faces(graph, layout)), kSameShape);
      std::vector<Triangle3> eroded;
      for (int panel = 0; panel < graph.panel_count(); ++panel) {
        for (int i = graph.first_face[panel]; i < graph.first_face[panel + 1]; ++i) {
          eroded.push_back(moved(layout[panel], foldable.faces[i]));
        }
      }
      EXPECT_LT(distortion(folder.eroded_faces(angles), eroded), kSameShape);
    }
  }
}

TEST(FoldBeside, TakesMountainsDownAndValleysUp) {
  // A roof and a gutter: from each panel the other one goes down, or up, whichever stays.
  const Mesh roof =
      make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, -1}, {0, -1, -1}}, {{0, 1, 2}, {1, 0, 3}});
  const Mesh gutter =
      make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 1}, {0, -1, 1}}, {{0, 1, 2}, {1, 0, 3}});
  for (const auto& [mesh, sign] : {std::pair(roof, -1), std::pair(gutter, 1)}) {
    const DualGraph graph = build_dual_graph(mesh);
    ASSERT_EQ(graph.hinge_count(), 1);
    EXPECT_NEAR(graph.hinges[0].angle, sign * std::acos(0.0), 1e-12);
    const Foldable foldable = make_foldable(graph);
    for (const int panel : {0, 1}) {
      const RigidMotion3 motion = fold_beside(foldable, 0, panel, graph.hinges[0].angle);
      double far = 0;
      for (const Vec3& p : moved(motion, graph.triangles[panel])) {
        if (std::abs(p.z()) > std::abs(far)) far = p.z();
      }
      EXPECT_NEAR(far, sign * std::sqrt(2.0), 1e-9);
    }
  }
}

TEST(FoldAngles, AreSharesOfTheModelsAngles) {
  const DualGraph graph = build_dual_graph(l_prism());
  const auto half = fold_angles(graph, 0.5);
  ASSERT_EQ(half.size(), graph.hinges.size());
  for (int h = 0; h < graph.hinge_count(); ++h) EXPECT_EQ(half[h], 0.5 * graph.hinges[h].angle);
  Random random(1);
  const FoldTree folds = random_tree(graph, random);
  std::vector<double> shares;
  for (std::size_t i = 0; i < folds.size(); ++i) shares.push_back(random.uniform());
  const auto mixed = fold_angles(graph, folds, shares);
  for (int h = 0; h < graph.hinge_count(); ++h) {
    const auto fold = std::ranges::lower_bound(folds, h);
    const bool is_fold = fold != folds.end() && *fold == h;
    EXPECT_EQ(mixed[h], is_fold ? shares[fold - folds.begin()] * graph.hinges[h].angle : 0);
  }
}

TEST(CollidingPanels, AreThoseThatLookingAtAllPairsFinds) {
  int colliding = 0;
  for (const Mesh& mesh : ordinary_meshes()) {
    SCOPED_TRACE(mesh.face_count());
    const DualGraph graph = build_dual_graph(mesh);
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      SCOPED_TRACE(seed);
      Random random(seed);
      const double clearance = seed % 2 == 0 ? kClearance : 0.001;
      const Foldable foldable = make_foldable(graph, clearance);
      const FoldTree folds = random_tree(graph, random);
      const PlainFolder folder(mesh, graph, folds, clearance);
      for (const double share : {0.0, 0.3, 0.7, 0.95, 1.0, 1.27}) {
        SCOPED_TRACE(share);
        const RootedTree tree = hang_tree(graph, folds, tree_centre(graph, folds));
        const auto angles = fold_angles(graph, share);
        const auto pairs = colliding_panels(foldable, tree, fold_up(foldable, tree, angles));
        EXPECT_EQ(pairs, folder.collisions(angles));
        colliding += static_cast<int>(pairs.size());
      }
    }
  }
  EXPECT_GT(colliding, 1000);
}

TEST(CollidingPanels, SparePanelsThatAFoldJoins) {
  // Folded onto each other, two panels meet everywhere, but a hinge holds them.
  const DualGraph graph = build_dual_graph(two_sided_square());
  const Foldable foldable = make_foldable(graph);
  for (const FoldTree& folds : all_spanning_trees(graph)) {
    const RootedTree tree = hang_tree(graph, folds);
    EXPECT_TRUE(
        colliding_panels(foldable, tree, fold_up(foldable, tree, fold_angles(graph, 1))).empty());
  }
  // The outer two of three are not joined.
  const DualGraph row = build_dual_graph(accordion({1, 1, 1}));
  const Foldable rolled = make_foldable(row);
  const RootedTree tree = hang_tree(row, FoldTree{0, 1});
  const std::vector<double> shut = {3.14159, 3.14159};
  const std::vector<std::array<int, 2>> outer = {{0, 2}};
  EXPECT_EQ(colliding_panels(rolled, tree, fold_up(rolled, tree, shut)), outer);
}

TEST(MeetsItself, IsSaidOfAComponentThatRunsThroughItself) {
  const Mesh mesh = crossing_strip();
  const DualGraph graph = build_dual_graph(mesh);
  ASSERT_EQ(graph.panel_count(), 5);
  ASSERT_EQ(graph.hinge_count(), 4);
  EXPECT_TRUE(meets_itself(make_foldable(graph)));
  // Without its last panel there is nothing to run through.
  EXPECT_FALSE(meets_itself(make_foldable(restrict_to(graph, std::vector<int>{0, 1, 2, 3}))));
}

TEST(MeetsItself, IsSaidOfFacesThatCoincide) {
  // A strip that runs round and comes to lie on its own beginning: in any pose, though rounding
  // puts the two faces now above and now below each other.
  const Mesh strip = make_mesh({{0, 0, 0},
                                {0, 1, 0},
                                {1, 0, 0},
                                {1, 1, 0},
                                {2, 0, 1},
                                {2, 1, 1},
                                {-1, 0, 1.1},
                                {-1, 1, 1.1}},
                               {{0, 2, 3}, {0, 3, 1}, {2, 4, 5}, {2, 5, 3}, {4, 6, 7}, {4, 7, 5}});
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Eigen::Quaterniond pose(random.normal(), random.normal(), random.normal(),
                                  random.normal());
    std::vector<Vec3> positions = strip.positions;
    // On from there: down to the floor again, and over the first square.
    for (const auto& p : {Vec3(-2, 0, 0), Vec3(-2, 1, 0), Vec3(1.5, 0, 0), Vec3(1.5, 1, 0)}) {
      positions.push_back(p);
    }
    std::vector<std::array<int, 3>> faces = strip.faces;
    faces.insert(faces.end(), {{6, 8, 9}, {6, 9, 7}, {8, 10, 11}, {8, 11, 9}});
    for (Vec3& p : positions) p = pose.normalized() * p;
    const DualGraph graph = build_dual_graph(make_mesh(positions, faces));
    ASSERT_EQ(graph.panel_count(), 5);
    EXPECT_TRUE(meets_itself(make_foldable(graph)));
  }
}

TEST(MeetsItself, IsNotSaidOfOrdinaryMeshes) {
  std::vector<Mesh> meshes = ordinary_meshes();
  meshes.push_back(two_sided_square());
  meshes.push_back(dumbbell());
  meshes.push_back(icosahedron());
  for (const Mesh& mesh : meshes) {
    SCOPED_TRACE(mesh.face_count());
    const DualGraph graph = build_dual_graph(mesh);
    EXPECT_FALSE(meets_itself(make_foldable(graph)));
    EXPECT_FALSE(meets_itself(make_foldable(graph, 0.001)));
  }
}

}  // namespace
}  // namespace foldwright::testing
