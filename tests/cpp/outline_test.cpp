#include "paper/outline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "drawn_shapes.h"
#include "meshes.h"
#include "trees.h"

namespace foldwright::testing {
namespace {

using Walks = std::vector<std::vector<int>>;

double signed_area(const Net& net, const std::vector<int>& walk) {
  double twice = 0;
  for (std::size_t i = 0; i < walk.size(); ++i) {
    twice += cross(net.vertices[walk[i]], net.vertices[walk[(i + 1) % walk.size()]]);
  }
  return twice / 2;
}

double area_of_faces(const Net& net) {
  double sum = 0;
  for (const auto& [a, b, c] : net.corners) sum += signed_area(net, {a, b, c});
  return sum;
}

/// The net of a mesh that lies in one plane.
Net flat_net(const Mesh& mesh) { return make_net(mesh, build_dual_graph(mesh), {}); }

/// Square frame around a square hole, one panel.
Mesh frame() {
  std::vector<Vec3> positions;
  for (const double size : {1.0, 3.0}) {
    for (const auto& [x, y] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, 1}}) {
      positions.emplace_back(size * x, size * y, 0);
    }
  }
  std::vector<std::array<int, 3>> faces;
  for (int i = 0; i < 4; ++i) {
    const int j = (i + 1) % 4;
    faces.insert(faces.end(), {{i, i + 4, j + 4}, {i, j + 4, j}});
  }
  return make_mesh(std::move(positions), std::move(faces));
}

/// A square of four triangles that is slit open from its right corner to its centre.
Mesh slit_square() {
  return make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {1, 0, 0}},
                   {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}});
}

TEST(BoundaryWalks, OfAFlatStripGoAroundIt) {
  const Net net = flat_net(open_strip(3));
  const Walks walks = boundary_walks(net);
  ASSERT_EQ(walks.size(), 1u);
  EXPECT_EQ(walks[0].size(), 8u);
  EXPECT_NEAR(signed_area(net, walks[0]), 3, 1e-12);
}

TEST(BoundaryWalks, GoAroundHolesClockwise) {
  const Net net = flat_net(frame());
  const Walks walks = boundary_walks(net);
  ASSERT_EQ(walks.size(), 2u);
  EXPECT_NEAR(signed_area(net, walks[0]), 36, 1e-12);
  EXPECT_NEAR(signed_area(net, walks[1]), -4, 1e-12);
}

TEST(BoundaryWalks, GoIntoASlitAndBack) {
  const Net net = flat_net(slit_square());
  const Walks walks = boundary_walks(net);
  ASSERT_EQ(walks.size(), 1u);
  ASSERT_EQ(walks[0].size(), 6u);
  const auto at_centre = std::ranges::find_if(walks[0], [&](int v) {
    return (net.vertices[v] - net.vertices[net.corners[0][0]]).norm() == 0;
  });
  ASSERT_NE(at_centre, walks[0].end());
  const auto i = static_cast<std::size_t>(at_centre - walks[0].begin());
  const int before = walks[0][(i + 5) % 6];
  const int after = walks[0][(i + 1) % 6];
  EXPECT_NE(before, after);
  EXPECT_LT((net.vertices[before] - net.vertices[after]).norm(), 1e-12);
}

TEST(BoundaryWalks, TakeEveryCutOnceAndEncloseTheFaces) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    for (const Mesh& mesh : {random_hull(seed, 30), star(), torus(8, 6), l_prism(), cube()}) {
      const DualGraph graph = build_dual_graph(mesh);
      const Net net = make_net(mesh, graph, random_tree(graph, random));
      std::map<std::array<int, 2>, int> uses;
      for (const NetEdge& edge : net.edges) {
        if (edge.assignment == Assignment::kCut) ++uses[edge.vertices];
      }
      const Walks walks = boundary_walks(net);
      double area = 0;
      for (const std::vector<int>& walk : walks) {
        EXPECT_GE(walk.size(), 3u);
        area += signed_area(net, walk);
        for (std::size_t i = 0; i < walk.size(); ++i) {
          --uses[{walk[i], walk[(i + 1) % walk.size()]}];
        }
      }
      for (const auto& [_, left] : uses) EXPECT_EQ(left, 0);
      EXPECT_NEAR(area, area_of_faces(net), 1e-9);
      EXPECT_GT(signed_area(net, walks[0]), 0);
    }
  }
}

}  // namespace
}  // namespace foldwright::testing
