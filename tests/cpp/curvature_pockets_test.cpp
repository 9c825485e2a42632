#include "segment/curvature_pockets.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "meshes.h"
#include "parts.h"
#include "trees.h"

namespace foldwright::testing {
namespace {

/// The fan as part 0 and the apron as part 1.
Labels fan_and_apron(const DualGraph& graph) {
  Labels labels;
  for (int panel = 0; panel < graph.panel_count(); ++panel) {
    labels.push_back(graph.panel_faces(panel)[0] < 8 ? 0 : 1);
  }
  return labels;
}

/// Connected parts around random panels.
Labels random_parts(const DualGraph& graph, int parts, Random& random) {
  Labels labels(graph.panel_count(), -1);
  for (int part = 0; part < parts; ++part) {
    int panel = 0;
    do panel = random.below(graph.panel_count());
    while (labels[panel] != -1);
    labels[panel] = part;
  }
  for (bool grew = true; grew;) {
    grew = false;
    for (const Hinge& hinge : graph.hinges) {
      const auto [a, b] = hinge.panels;
      if ((labels[a] == -1) == (labels[b] == -1)) continue;
      if (random.below(3) > 0) labels[a] = labels[b] = std::max(labels[a], labels[b]);
      grew = true;
    }
  }
  return labels;
}

TEST(PocketDeficit, IsTheCurvatureThatASaddleLacks) {
  const Mesh mesh = saddle_with_apron(7, 3);
  const DualGraph graph = build_dual_graph(mesh);
  // The tip is the only inner vertex of the fan, with 7 radians of face around it.
  EXPECT_NEAR(pocket_deficit(mesh, graph, fan_and_apron(graph)), 7 - 2 * std::numbers::pi, 1e-9);
  // Alone it has the same; cut through the tip it has none.
  const Mesh alone = saddle(8, 7);
  const DualGraph fan = build_dual_graph(alone);
  EXPECT_NEAR(pocket_deficit(alone, fan, Labels(8, 0)), 7 - 2 * std::numbers::pi, 1e-9);
  EXPECT_EQ(pocket_deficit(alone, fan, {0, 0, 0, 0, 1, 1, 1, 1}), 0);
}

TEST(PocketDeficit, IsNoneOfConvexModels) {
  for (const Mesh& mesh : {cube(), icosahedron(), random_hull(1, 40)}) {
    const DualGraph graph = build_dual_graph(mesh);
    EXPECT_EQ(pocket_deficit(mesh, graph, Labels(graph.panel_count(), 0)), 0);
    Random random(1);
    EXPECT_EQ(pocket_deficit(mesh, graph, random_parts(graph, 3, random)), 0);
  }
}

/// The deficit by its definition, from loops over everything.
double plain_deficit(const Mesh& mesh, const DualGraph& graph, const Labels& labels) {
  const int n = mesh.vertex_count();
  std::vector<double> curvature(n, 2 * std::numbers::pi);
  std::vector<int> part(mesh.face_count(), -1);
  for (int panel = 0; panel < graph.panel_count(); ++panel) {
    for (const int face : graph.panel_faces(panel)) part[face] = labels[panel];
  }
  // -1: not seen yet, -2: on a border of parts or of the model.
  std::vector<int> part_at(n, -1);
  for (int f = 0; f < mesh.face_count(); ++f) {
    for (int i = 0; i < 3; ++i) {
      const int v = mesh.faces[f][i];
      const Vec3 a = (mesh.positions[mesh.faces[f][(i + 1) % 3]] - mesh.positions[v]).normalized();
      const Vec3 b = (mesh.positions[mesh.faces[f][(i + 2) % 3]] - mesh.positions[v]).normalized();
      curvature[v] -= std::acos(std::clamp(a.dot(b), -1.0, 1.0));
      if (part_at[v] == -1) part_at[v] = part[f];
      if (part_at[v] != part[f]) part_at[v] = -2;
    }
  }
  for (const Mesh::Edge& edge : mesh.edges) {
    if (edge.faces[1] == -1) part_at[edge.vertices[0]] = part_at[edge.vertices[1]] = -2;
  }
  std::vector<int> pocket(n);
  for (int v = 0; v < n; ++v) pocket[v] = v;
  for (bool changed = true; changed;) {
    changed = false;
    for (const Hinge& hinge : graph.hinges) {
      for (const int e : hinge.edges) {
        const auto [v, w] = mesh.edges[e].vertices;
        if (part_at[v] < 0 || part_at[w] < 0 || pocket[v] == pocket[w]) continue;
        pocket[v] = pocket[w] = std::min(pocket[v], pocket[w]);
        changed = true;
      }
    }
  }
  double sum = 0;
  for (int first = 0; first < n; ++first) {
    double positive = 0;
    double negative = 0;
    for (int v = 0; v < n; ++v) {
      if (part_at[v] < 0 || pocket[v] != first) continue;
      (curvature[v] > 0 ? positive : negative) += std::abs(curvature[v]);
    }
    const double lack = negative - 5 * positive;
    if (lack > 1e-7) sum += lack;
  }
  return sum;
}

std::vector<Mesh> hilly_meshes() {
  return {bumpy_sphere(200), torus(12, 8), dumbbell(), star(), saddle_with_apron(8, 5)};
}

TEST(PocketDeficit, EqualsThePlainSum) {
  int with_pockets = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    for (const Mesh& mesh : hilly_meshes()) {
      SCOPED_TRACE(mesh.face_count());
      const DualGraph graph = build_dual_graph(mesh);
      const Labels labels = random_parts(graph, 1 + random.below(6), random);
      const double deficit = pocket_deficit(mesh, graph, labels);
      EXPECT_NEAR(deficit, plain_deficit(mesh, graph, labels), 1e-6);
      with_pockets += deficit > 0 ? 1 : 0;
    }
  }
  EXPECT_GT(with_pockets, 5);
}

TEST(OpenPockets, LessensTheDeficitAndKeepsPartsWhole) {
  int opened = 0;
  int closed = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    for (const Mesh& mesh : hilly_meshes()) {
      SCOPED_TRACE(mesh.face_count());
      const DualGraph graph = build_dual_graph(mesh);
      const int parts = 2 + random.below(6);
      const Labels labels = random_parts(graph, parts, random);
      ASSERT_EQ(fault_of_parts(graph, labels), "");
      const double before = pocket_deficit(mesh, graph, labels);
      const Labels after = open_pockets(mesh, graph, labels);
      EXPECT_EQ(fault_of_parts(graph, after), "");
      EXPECT_EQ(part_count(after), parts);
      if (before == 0) {
        ++closed;
        EXPECT_EQ(after, labels) << "there was nothing to open";
        continue;
      }
      const double left = pocket_deficit(mesh, graph, after);
      EXPECT_LE(left, before);
      EXPECT_EQ(left < before, after != labels);
      EXPECT_EQ(open_pockets(mesh, graph, after), after) << "it could have gone on";
      opened += left < before ? 1 : 0;
    }
  }
  EXPECT_GT(opened, 5);
  EXPECT_GT(closed, 5);
}

TEST(OpenPockets, LetsASaddleHaveANet) {
  const Mesh mesh = saddle_with_apron(7, 3);
  const DualGraph graph = build_dual_graph(mesh);
  const Labels after = open_pockets(mesh, graph, fan_and_apron(graph));
  EXPECT_EQ(pocket_deficit(mesh, graph, after), 0);
  EXPECT_EQ(fault_of_parts(graph, after), "");
  const DualGraph fan = restrict_to(graph, panels_of(after, 0));
  EXPECT_TRUE(std::ranges::any_of(all_spanning_trees(fan),
                                  [&](const FoldTree& folds) { return is_net(mesh, fan, folds); }));
}

TEST(OpenPockets, CannotHelpAPartWithoutANeighbour) {
  const Mesh mesh = saddle(8, 7);
  const DualGraph graph = build_dual_graph(mesh);
  EXPECT_EQ(open_pockets(mesh, graph, Labels(8, 0)), Labels(8, 0));
}

}  // namespace
}  // namespace foldwright::testing
