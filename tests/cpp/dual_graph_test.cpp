#include "mesh/dual_graph.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "drawn_shapes.h"
#include "meshes.h"
#include "repair/repair.h"

namespace foldwright::testing {
namespace {

constexpr double kRightAngle = std::numbers::pi / 2;

std::vector<Mesh> named_meshes() {
  return {cube(),
          tetrahedron(),
          icosahedron(),
          star(),
          torus(8, 6),
          l_prism(),
          two_sided_square(),
          open_strip(3),
          saddle(8, 7),
          accordion({1, 2, 3}),
          dumbbell(),
          repair(mobius_strip(5)).mesh};
}

/// A mesh corner of a panel in the panel's coordinates.
Vec2 flat_corner(const Mesh& mesh, const DualGraph& graph, int panel, int vertex) {
  for (int slot = graph.first_face[panel]; slot < graph.first_face[panel + 1]; ++slot) {
    for (int i = 0; i < 3; ++i) {
      if (mesh.faces[graph.faces[slot]][i] == vertex) return graph.triangles[slot][i];
    }
  }
  ADD_FAILURE() << "panel " << panel << " has no vertex " << vertex;
  return Vec2::Zero();
}

/// Number of faces of each panel, sorted.
std::vector<int> panel_sizes(const DualGraph& graph) {
  std::vector<int> sizes;
  for (int panel = 0; panel < graph.panel_count(); ++panel) {
    sizes.push_back(static_cast<int>(graph.panel_faces(panel).size()));
  }
  std::sort(sizes.begin(), sizes.end());
  return sizes;
}

/// A cube with a further vertex in the middle of one edge.
Mesh cube_with_split_edge() {
  Mesh mesh = cube();
  const auto [a, b] = mesh.edges[0].vertices;
  const int middle = mesh.vertex_count();
  mesh.positions.push_back(0.5 * (mesh.positions[a] + mesh.positions[b]));
  std::vector<std::array<int, 3>> faces;
  for (const auto& face : mesh.faces) {
    const auto start = std::find_if(face.begin(), face.end(), [&](const int& v) {
      const int next = face[(&v - face.data() + 1) % 3];
      return (v == a && next == b) || (v == b && next == a);
    });
    if (start == face.end()) {
      faces.push_back(face);
      continue;
    }
    const int next = face[(start - face.begin() + 1) % 3];
    const int apex = face[(start - face.begin() + 2) % 3];
    faces.insert(faces.end(), {{*start, middle, apex}, {middle, next, apex}});
  }
  return make_mesh(mesh.positions, std::move(faces));
}

TEST(DualGraph, OfACubeHasSixPanelsAndTwelveMountains) {
  const DualGraph graph = build_dual_graph(cube());
  EXPECT_EQ(panel_sizes(graph), std::vector<int>(6, 2));
  ASSERT_EQ(graph.hinge_count(), 12);
  for (const Hinge& hinge : graph.hinges) {
    EXPECT_NEAR(hinge.angle, -kRightAngle, 1e-12);
    EXPECT_NEAR(hinge.length, 1, 1e-12);
    EXPECT_EQ(hinge.edges.size(), 1u);
  }
  for (const double area : graph.areas) EXPECT_NEAR(area, 1, 1e-12);
  EXPECT_NEAR(graph.unit, (12 + 6 * std::numbers::sqrt2) / 18, 1e-12);
}

TEST(DualGraph, OfAnLHasHexagonsAndOneValley) {
  const DualGraph graph = build_dual_graph(l_prism());
  EXPECT_EQ(panel_sizes(graph), (std::vector<int>{2, 2, 2, 2, 2, 2, 4, 4}));
  ASSERT_EQ(graph.hinge_count(), 18);
  int valleys = 0;
  for (const Hinge& hinge : graph.hinges) {
    EXPECT_NEAR(std::abs(hinge.angle), kRightAngle, 1e-12);
    valleys += hinge.angle > 0;
  }
  EXPECT_EQ(valleys, 1);
}

TEST(DualGraph, AngleOfARegularTetrahedron) {
  for (const Hinge& hinge : build_dual_graph(tetrahedron()).hinges) {
    EXPECT_NEAR(hinge.angle, -(std::numbers::pi - std::acos(1.0 / 3)), 1e-12);
  }
}

TEST(DualGraph, MakesOneHingeOfCollinearEdges) {
  const Mesh mesh = cube_with_split_edge();
  const DualGraph graph = build_dual_graph(mesh);
  EXPECT_EQ(graph.panel_count(), 6);
  ASSERT_EQ(graph.hinge_count(), 12);
  int doubled = 0;
  for (const Hinge& hinge : graph.hinges) {
    doubled += hinge.edges.size() == 2;
    EXPECT_NEAR(hinge.length, 1, 1e-12);
  }
  EXPECT_EQ(doubled, 1);
}

TEST(DualGraph, OfATwoSidedSquareHasTwoPanelsAndFourHinges) {
  const DualGraph graph = build_dual_graph(two_sided_square());
  EXPECT_EQ(graph.panel_count(), 2);
  ASSERT_EQ(graph.hinge_count(), 4);
  for (const Hinge& hinge : graph.hinges) EXPECT_NEAR(hinge.angle, -std::numbers::pi, 1e-12);
}

TEST(DualGraph, FlatFacesArePanelsUpToATinyAngleOnly) {
  const auto bent_strip = [](double angle) {
    return make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, std::tan(angle) / std::sqrt(2)}},
                     {{0, 1, 2}, {1, 3, 2}});
  };
  EXPECT_EQ(build_dual_graph(bent_strip(0.9 * kPanelAngle)).panel_count(), 1);
  EXPECT_EQ(build_dual_graph(bent_strip(1.1 * kPanelAngle)).panel_count(), 2);
  EXPECT_EQ(build_dual_graph(open_strip(50)).panel_count(), 1);
}

TEST(DualGraph, CoplanarFacesThatOverlapArePanelsOfTheirOwn) {
  // Two turns around a vertex in one plane: no flat panel can be made of that.
  std::vector<Vec3> positions = {Vec3::Zero()};
  std::vector<std::array<int, 3>> faces;
  for (int i = 0; i <= 12; ++i) {
    const double angle = std::numbers::pi / 3 * i;
    positions.emplace_back(std::cos(angle), std::sin(angle), 0);
    if (i > 0) faces.push_back({0, i, i + 1});
  }
  const DualGraph graph = build_dual_graph(make_mesh(std::move(positions), std::move(faces)));
  EXPECT_EQ(graph.panel_count(), 12);
  EXPECT_EQ(graph.hinge_count(), 11);
}

TEST(DualGraph, HasEveryFaceOnceAndCongruent) {
  for (const Mesh& mesh : named_meshes()) {
    const DualGraph graph = build_dual_graph(mesh);
    SCOPED_TRACE(mesh.face_count());
    std::vector<int> faces = graph.faces;
    std::sort(faces.begin(), faces.end());
    for (int f = 0; f < mesh.face_count(); ++f) ASSERT_EQ(faces[f], f);
    for (int slot = 0; slot < mesh.face_count(); ++slot) {
      const Triangle2& flat = graph.triangles[slot];
      const auto& corners = mesh.faces[graph.faces[slot]];
      EXPECT_GT(cross(flat[1] - flat[0], flat[2] - flat[0]), 0);
      for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        EXPECT_NEAR((flat[j] - flat[i]).norm(),
                    (mesh.positions[corners[j]] - mesh.positions[corners[i]]).norm(), 1e-12);
      }
    }
  }
}

TEST(DualGraph, HingesLayPanelsBesideEachOther) {
  for (const Mesh& mesh : named_meshes()) {
    const DualGraph graph = build_dual_graph(mesh);
    SCOPED_TRACE(mesh.face_count());
    for (int h = 0; h < graph.hinge_count(); ++h) {
      const Hinge& hinge = graph.hinges[h];
      const auto [low, high] = hinge.panels;
      EXPECT_LT(low, high);
      for (const int e : hinge.edges) {
        Vec2 ends[2];
        for (const int i : {0, 1}) {
          const int vertex = mesh.edges[e].vertices[i];
          ends[i] = flat_corner(mesh, graph, low, vertex);
          const Vec2 laid = hinge.lay(flat_corner(mesh, graph, high, vertex));
          EXPECT_LT((laid - ends[i]).norm(), 1e-12);
          EXPECT_LT(
              (graph.lay_beside(h, low)(ends[i]) - flat_corner(mesh, graph, high, vertex)).norm(),
              1e-12);
        }
        // The two faces at the edge lie on different sides of it.
        const auto& faces = mesh.edges[e].faces;
        double sides[2];
        for (const int i : {0, 1}) {
          const auto& corners = mesh.faces[faces[i]];
          const bool is_low = std::ranges::count(graph.panel_faces(low), faces[i]) > 0;
          Vec2 sum = Vec2::Zero();
          for (const int v : corners) sum += flat_corner(mesh, graph, is_low ? low : high, v);
          const Vec2 centre = sum / 3;
          sides[i] = cross(ends[1] - ends[0], (is_low ? centre : hinge.lay(centre)) - ends[0]);
        }
        EXPECT_LT(sides[0] * sides[1], 0);
      }
    }
  }
}

TEST(DualGraph, ListsTheHingesOfEachPanel) {
  for (const Mesh& mesh : named_meshes()) {
    const DualGraph graph = build_dual_graph(mesh);
    SCOPED_TRACE(mesh.face_count());
    std::size_t listed = 0;
    for (int panel = 0; panel < graph.panel_count(); ++panel) {
      const auto hinges = graph.hinges_of(panel);
      EXPECT_TRUE(std::ranges::is_sorted(hinges));
      listed += hinges.size();
      for (const int h : hinges) {
        EXPECT_EQ(graph.hinges[h].other(graph.hinges[h].other(panel)), panel);
      }
    }
    EXPECT_EQ(listed, 2 * graph.hinges.size());
  }
}

TEST(DualGraph, RestrictedKeepsPanelsAndTheHingesBetweenThem) {
  const DualGraph graph = build_dual_graph(star());
  const std::vector<int> panels = {1, 2, 5, 17, 18, 19, 40, 59};
  const DualGraph part = restrict_to(graph, panels);
  ASSERT_EQ(part.panel_count(), 8);
  EXPECT_EQ(part.unit, graph.unit);
  for (int panel = 0; panel < 8; ++panel) {
    EXPECT_TRUE(std::ranges::equal(part.panel_faces(panel), graph.panel_faces(panels[panel])));
    EXPECT_EQ(part.panel_triangles(panel)[0], graph.panel_triangles(panels[panel])[0]);
    EXPECT_EQ(part.areas[panel], graph.areas[panels[panel]]);
  }
  int between = 0;
  for (const Hinge& hinge : graph.hinges) {
    const auto chosen = [&](int panel) { return std::ranges::binary_search(panels, panel); };
    if (!chosen(hinge.panels[0]) || !chosen(hinge.panels[1])) continue;
    ++between;
    EXPECT_EQ(std::ranges::count_if(part.hinges,
                                    [&](const Hinge& h) {
                                      return panels[h.panels[0]] == hinge.panels[0] &&
                                             panels[h.panels[1]] == hinge.panels[1] &&
                                             h.edges == hinge.edges && h.angle == hinge.angle;
                                    }),
              1);
  }
  EXPECT_EQ(part.hinge_count(), between);
  EXPECT_GT(between, 0);
}

}  // namespace
}  // namespace foldwright::testing
