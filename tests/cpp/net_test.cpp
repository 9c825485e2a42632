#include "unfold/net.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numbers>

#include "drawn_shapes.h"
#include "meshes.h"
#include "trees.h"

namespace foldwright::testing {
namespace {

int count(const Net& net, Assignment assignment) {
  return static_cast<int>(std::ranges::count(net.edges, assignment, &NetEdge::assignment));
}

Net first_net(const Mesh& mesh, const DualGraph& graph) {
  for (const FoldTree& folds : all_spanning_trees(graph)) {
    if (is_net(mesh, graph, folds)) return make_net(mesh, graph, folds);
  }
  ADD_FAILURE() << "no net at all";
  return {};
}

Net cube_net() {
  const Mesh mesh = cube();
  return first_net(mesh, build_dual_graph(mesh));
}

TEST(MakeNet, OfACubeByHand) {
  const Net net = cube_net();
  EXPECT_EQ(net.faces, (std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}));
  EXPECT_EQ(net.vertices.size(), 14u);  // the outline is 14 edges long and has all corners on it
  EXPECT_EQ(count(net, Assignment::kCut), 14);
  EXPECT_EQ(count(net, Assignment::kMountain), 5);
  EXPECT_EQ(count(net, Assignment::kFlat), 6);
  EXPECT_EQ(count(net, Assignment::kValley), 0);
  for (const NetEdge& edge : net.edges) {
    const bool folds = edge.assignment == Assignment::kMountain;
    EXPECT_NEAR(edge.angle, folds ? -std::numbers::pi / 2 : 0, 1e-12);
  }
}

TEST(MakeNet, MarksTheValleyOfAnL) {
  const Mesh mesh = l_prism();
  const DualGraph graph = build_dual_graph(mesh);
  const auto valley = static_cast<int>(
      std::ranges::find_if(graph.hinges, [](const Hinge& h) { return h.angle > 0; }) -
      graph.hinges.begin());
  std::vector<double> weights(graph.hinge_count(), 1);
  weights[valley] = 0;
  const Net net = make_net(mesh, graph, minimum_spanning_tree(graph, weights));
  EXPECT_EQ(count(net, Assignment::kValley), 1);
  EXPECT_EQ(count(net, Assignment::kMountain), 6);
  for (const NetEdge& edge : net.edges) {
    if (edge.assignment != Assignment::kValley) continue;
    EXPECT_EQ(edge.mesh_edge, graph.hinges[valley].edges[0]);
    EXPECT_NEAR(edge.angle, std::numbers::pi / 2, 1e-12);
  }
}

TEST(MakeNet, HasEachFoldOnceAndEachCutOncePerSide) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    for (const Mesh& mesh : {random_hull(seed, 30), star(), torus(8, 5), accordion({1, 2, 1})}) {
      const DualGraph graph = build_dual_graph(mesh);
      const FoldTree folds = random_tree(graph, random);
      const Net net = make_net(mesh, graph, folds);
      std::map<int, int> uses;
      for (const NetEdge& edge : net.edges) {
        ++uses[edge.mesh_edge];
        const bool border = mesh.edges[edge.mesh_edge].faces[1] == -1;
        EXPECT_TRUE(!border || edge.assignment == Assignment::kCut);
      }
      int folded = 0;
      for (int e = 0; e < mesh.edge_count(); ++e) {
        const bool border = mesh.edges[e].faces[1] == -1;
        const bool fold = !border && uses[e] == 1;
        EXPECT_EQ(uses[e], border || fold ? 1 : 2);
        folded += fold;
      }
      // A tree over the panels, and one within each, as none of these has a hole: no circles.
      EXPECT_EQ(folded, mesh.face_count() - 1);
      // A tree of n triangles has n + 2 vertices when each fold shares its two.
      EXPECT_EQ(static_cast<int>(net.vertices.size()), mesh.face_count() + 2);
    }
  }
}

TEST(MakeNet, OfSomePanelsHasTheirFacesOnly) {
  const Mesh mesh = star();
  const DualGraph whole = build_dual_graph(mesh);
  const std::vector<int> spike = {30, 31, 32};
  const DualGraph graph = restrict_to(whole, spike);
  const Net net = first_net(mesh, graph);
  EXPECT_EQ(net.faces, spike);
  EXPECT_EQ(count(net, Assignment::kCut), 5);
  EXPECT_EQ(count(net, Assignment::kMountain), 2);
}

TEST(CheckNet, FindsNothingWrongWithANet) {
  const NetCheck check = check_net(cube(), cube_net());
  EXPECT_TRUE(check.valid());
  EXPECT_EQ(check.overlaps, 0);
  EXPECT_EQ(check.mirrored, 0);
  EXPECT_EQ(check.unconnected, 0);
  EXPECT_LT(check.length_error, 1e-12);
}

TEST(CheckNet, FindsAMirroredNet) {
  Net net = cube_net();
  for (Vec2& vertex : net.vertices) vertex.x() *= -1;
  EXPECT_EQ(check_net(cube(), net).mirrored, 12);
  EXPECT_FALSE(check_net(cube(), net).valid());
}

TEST(CheckNet, FindsOverlaps) {
  const Mesh mesh = saddle(8, 7);
  const DualGraph graph = build_dual_graph(mesh);
  const NetCheck check = check_net(mesh, make_net(mesh, graph, all_spanning_trees(graph)[3]));
  EXPECT_EQ(check.overlaps, 1);
  EXPECT_EQ(check.unconnected, 0);
  EXPECT_FALSE(check.valid());
}

TEST(CheckNet, FindsAStretchedEdge) {
  Net net = cube_net();
  net.vertices[3] += Vec2(1e-5, 1e-5);
  const NetCheck check = check_net(cube(), net);
  EXPECT_GT(check.length_error, 1e-6);
  EXPECT_LT(check.length_error, 1e-4);
  EXPECT_FALSE(check.valid());
}

TEST(CheckNet, FindsATornNet) {
  Net net = cube_net();
  for (int& corner : net.corners[11]) {  // the last face goes away, with corners of its own
    net.vertices.push_back(net.vertices[corner] + Vec2(100, 0));
    corner = static_cast<int>(net.vertices.size()) - 1;
  }
  const NetCheck check = check_net(cube(), net);
  EXPECT_GE(check.unconnected, 1);
  EXPECT_FALSE(check.valid());
}

TEST(CheckNet, AgreesWithTheLayoutOnOverlaps) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Mesh mesh = random_hull(seed, 40);
    const DualGraph graph = build_dual_graph(mesh);
    const FoldTree folds = random_tree(graph, random);
    EXPECT_EQ(check_net(mesh, make_net(mesh, graph, folds)).overlaps,
              static_cast<int>(overlaps_of(graph, folds).size()));
  }
}

}  // namespace
}  // namespace foldwright::testing
