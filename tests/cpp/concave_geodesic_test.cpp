#include "segment/concave_geodesic.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "drawn_shapes.h"
#include "meshes.h"

namespace foldwright::testing {
namespace {

TEST(ConcaveGeodesic, OfARowByHand) {
  // Panels of width 1, 1 and 2 in a row; the first hinge is a mountain, the second a valley. From
  // centroid to midpoint to centroid it is 1 and 1.5: relative 0.8 and 1.2. The bends are
  // 0.05 (1 - cos 90) and 1 (1 - cos 90): relative 2 * 0.05 / 1.05 and 2 / 1.05.
  const Mesh mesh = accordion({1, 1, 2});
  const DualGraph graph = build_dual_graph(mesh);
  ASSERT_LT(graph.hinges[0].angle, 0);
  ASSERT_GT(graph.hinges[1].angle, 0);
  const double first = 0.1 * 0.8 + 0.9 * 0.1 / 1.05;
  const double second = 0.1 * 1.2 + 0.9 * 2 / 1.05;
  const double mean = 4 * (first + second) / 9;  // of all nine entries
  const std::vector<float> distances = concave_geodesic(mesh, graph);
  ASSERT_EQ(distances.size(), 9u);
  EXPECT_NEAR(distances[1], first / mean, 1e-6);
  EXPECT_NEAR(distances[5], second / mean, 1e-6);
  EXPECT_NEAR(distances[2], (first + second) / mean, 1e-6);
}

TEST(ConcaveGeodesic, IsAMetricOfMeanOne) {
  for (const Mesh& mesh : {star(), l_prism(), torus(8, 6)}) {
    const DualGraph graph = build_dual_graph(mesh);
    const int n = graph.panel_count();
    const std::vector<float> d = concave_geodesic(mesh, graph);
    EXPECT_NEAR(std::accumulate(d.begin(), d.end(), 0.0) / (n * n), 1, 1e-5);
    for (int i = 0; i < n; ++i) {
      EXPECT_EQ(d[i * n + i], 0);
      for (int j = 0; j < n; ++j) {
        EXPECT_NEAR(d[i * n + j], d[j * n + i], 1e-5);
        for (int k = 0; k < n; ++k) EXPECT_LE(d[i * n + j], d[i * n + k] + d[k * n + j] + 1e-5);
      }
    }
  }
}

TEST(ConcaveGeodesic, IsLongAcrossANeck) {
  const Mesh mesh = dumbbell();
  const DualGraph graph = build_dual_graph(mesh);
  const int n = graph.panel_count();
  const std::vector<float> distances = concave_geodesic(mesh, graph);
  const auto height = [&](int panel) {
    double sum = 0;
    const int face = graph.panel_faces(panel)[0];
    for (const int v : mesh.faces[face]) sum += mesh.positions[v].z();
    return sum / 3;
  };
  double within = 0;
  double across = 1e9;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      if (std::abs(height(i)) < 0.5 || std::abs(height(j)) < 0.5) continue;
      const bool same_ball = (height(i) > 0) == (height(j) > 0);
      if (same_ball) {
        within = std::max(within, static_cast<double>(distances[i * n + j]));
      } else {
        across = std::min(across, static_cast<double>(distances[i * n + j]));
      }
    }
  }
  EXPECT_LT(within, across);
}

TEST(ConcaveGeodesic, IsFiniteBetweenWhatIsNotConnected) {
  const Mesh mesh = cube();
  const DualGraph whole = build_dual_graph(mesh);
  // Opposite sides; then two of them with a neighbour of one.
  for (const auto& panels : std::vector<std::vector<int>>{{0, 1}, {0, 1, 2}, {0}}) {
    const std::vector<float> distances = concave_geodesic(mesh, restrict_to(whole, panels));
    for (const float distance : distances) {
      EXPECT_TRUE(std::isfinite(distance));
      EXPECT_GE(distance, 0);
    }
  }
  EXPECT_GT(concave_geodesic(mesh, restrict_to(whole, std::vector<int>{0, 1}))[1], 100);
}

}  // namespace
}  // namespace foldwright::testing
