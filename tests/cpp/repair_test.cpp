#include "repair/repair.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "geometry/random.h"
#include "mesh/dual_graph.h"
#include "meshes.h"
#include "model_text.h"
#include "sound_repair.h"

namespace foldwright::testing {
namespace {

/// The soup with all faces of another one added, shifted.
PolygonSoup with(PolygonSoup soup, const PolygonSoup& other, const Vec3& shift) {
  const int offset = static_cast<int>(soup.positions.size());
  for (const Vec3& p : other.positions) soup.positions.push_back(p + shift);
  for (int f = 0; f < other.face_count(); ++f) {
    for (const int corner : corners_of(other, f)) soup.corners.push_back(corner + offset);
    soup.first_corner.push_back(static_cast<int>(soup.corners.size()));
  }
  return soup;
}

PolygonSoup inside_out(const PolygonSoup& soup) {
  std::vector<std::vector<int>> polygons;
  for (int f = 0; f < soup.face_count(); ++f) {
    polygons.push_back(corners_of(soup, f));
    std::reverse(polygons.back().begin(), polygons.back().end());
  }
  return testing::soup(soup.positions, polygons);
}

TEST(Repair, LeavesSoundMeshesAsTheyAre) {
  for (const Mesh& mesh :
       {cube(), tetrahedron(), icosahedron(), star(), torus(9, 5), random_hull(1, 50)}) {
    const RepairedModel model = sound_repair(soup_of(mesh));
    EXPECT_TRUE(model.repairs.empty());
    EXPECT_EQ(model.mesh.face_count(), mesh.face_count());
    EXPECT_EQ(model.mesh.source_faces, mesh.source_faces);
    EXPECT_EQ(border_edge_count(model.mesh), 0);
  }
}

TEST(Repair, CentresTheBoundingBox) {
  PolygonSoup moved = soup_of(cube());
  for (Vec3& p : moved.positions) p += Vec3(1e6, 0, -5);
  EXPECT_EQ(sound_repair(moved).mesh.positions, cube().positions);
}

TEST(Repair, WorksAtAnyScale) {
  for (const double scale : {1e-30, 1e-12, 1e30}) {
    PolygonSoup scaled = soup_of(star());
    for (Vec3& p : scaled.positions) p *= scale;
    const RepairedModel model = sound_repair(scaled);
    EXPECT_TRUE(model.repairs.empty());
    EXPECT_EQ(model.mesh.face_count(), 60);
  }
}

TEST(Repair, RefusesWhatHasNoArea) {
  const auto code = [](const PolygonSoup& soup) -> std::string {
    try {
      repair(soup);
    } catch (const InputError& error) {
      return error.code();
    }
    return "";
  };
  EXPECT_EQ(code(soup({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, {{0, 1, 2}})), "no-area");
  EXPECT_EQ(code(soup({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}})), "no-area");
  EXPECT_EQ(code(soup({{0, 0, 0}, {1e200, 0, 0}, {0, 1e200, 0}}, {{0, 1, 2}})), "bad-size");
  EXPECT_EQ(code(soup({{0, 0, 0}, {1.7e308, 0, 0}, {-1.7e308, 1, 0}}, {{0, 1, 2}})), "bad-size");
  EXPECT_EQ(code(soup({{0, 0, 0}}, {{}})), "no-faces");
}

TEST(Repair, WeldsCopiesAndDropsUnusedVertices) {
  PolygonSoup loose;  // every triangle with its own corners, as in STL
  for (const auto& [a, b, c] : star().faces) {
    const std::vector<Vec3>& p = star().positions;
    loose = with(loose, soup({p[a], p[b], p[c]}, {{0, 1, 2}}), Vec3::Zero());
  }
  loose.positions.emplace_back(1e20, 0, 0);  // far away, but no face uses it
  const RepairedModel model = sound_repair(loose);
  EXPECT_EQ(model.mesh.vertex_count(), 32);
  EXPECT_EQ(count_of(model, "welded-vertices"), 180 - 32);
  EXPECT_EQ(count_of(model, "dropped-unused-vertices"), 1);
  EXPECT_EQ(border_edge_count(model.mesh), 0);
}

TEST(Repair, DropsDegenerateAndDuplicateFaces) {
  PolygonSoup spoilt = soup_of(cube());
  const PolygonSoup extra =
      soup({}, {{0, 1, 1}, {0, 1}, {0}, {}, {3, 0, 1}, {4, 6, 7}, {0, 1, 0, 1}});
  for (int f = 0; f < extra.face_count(); ++f) {
    for (const int corner : corners_of(extra, f)) spoilt.corners.push_back(corner);
    spoilt.first_corner.push_back(static_cast<int>(spoilt.corners.size()));
  }
  const RepairedModel model = sound_repair(spoilt);
  EXPECT_EQ(count_of(model, "dropped-degenerate-faces"), 5);
  EXPECT_EQ(count_of(model, "dropped-duplicate-faces"), 2);
  EXPECT_EQ(model.mesh.face_count(), 12);
}

TEST(Repair, FindsDuplicatePolygonsThatBeginElsewhere) {
  const RepairedModel model = sound_repair(
      soup({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}, {1, 2, 3, 0}}));
  EXPECT_EQ(count_of(model, "dropped-duplicate-faces"), 1);
  EXPECT_EQ(model.mesh.face_count(), 2);
}

TEST(Repair, MakesOneSkinOfASheetGivenFromBothSides) {
  const PolygonSoup strip = soup_of(open_strip(3));
  const RepairedModel model = sound_repair(with(strip, inside_out(strip), Vec3::Zero()));
  EXPECT_EQ(model.mesh.component_count, 1);
  EXPECT_EQ(model.mesh.face_count(), 6);
  EXPECT_EQ(count_of(model, "merged-two-sided"), 6);
}

TEST(Repair, MakesOneSkinOfPolygonsGivenFromBothSides) {
  // Two panels of a tent, each from the front and from the back.
  const RepairedModel model =
      sound_repair(soup({{0, 0, 0}, {6, 0, 0}, {6, 3, 2.5}, {0, 3, 2.5}, {6, 0, 5}, {0, 0, 5}},
                        {{0, 1, 2, 3}, {3, 2, 4, 5}, {3, 2, 1, 0}, {5, 4, 2, 3}}));
  EXPECT_EQ(count_of(model, "merged-two-sided"), 2);
  EXPECT_EQ(count_of(model, "split-nonmanifold-edges"), 0);
  EXPECT_EQ(model.mesh.face_count(), 4);
  EXPECT_EQ(border_edge_count(model.mesh), 6);
}

/// A polygon as a fan of triangles from one of its corners, with either side up.
void add_fan(std::vector<std::vector<int>>& faces, const std::vector<int>& polygon, int from,
             bool is_turned) {
  const int n = static_cast<int>(polygon.size());
  for (int i = 1; i + 1 < n; ++i) {
    std::vector<int> face = {polygon[from], polygon[(from + i) % n], polygon[(from + i + 1) % n]};
    if (is_turned) std::swap(face[1], face[2]);
    faces.push_back(face);
  }
}

/// Corners of regular polygons, one above the other.
std::vector<Vec3> prism_corners(int n, int floors) {
  std::vector<Vec3> corners;
  for (int floor = 0; floor < floors; ++floor) {
    for (int i = 0; i < n; ++i) {
      const double angle = 2 * std::numbers::pi * i / n;
      corners.emplace_back(3 * std::cos(angle), 3 * std::sin(angle), 2 * floor);
    }
  }
  return corners;
}

/// The corners of one floor, counter-clockwise from above.
std::vector<int> floor_of_prism(int n, int floor) {
  std::vector<int> polygon(n);
  std::iota(polygon.begin(), polygon.end(), floor * n);
  return polygon;
}

void add_sides(std::vector<std::vector<int>>& faces, int n, int floor) {
  for (int i = 0; i < n; ++i) {
    const int j = (i + 1) % n;
    faces.push_back({floor * n + i, floor * n + j, (floor + 1) * n + j, (floor + 1) * n + i});
  }
}

TEST(Repair, TakesAPolygonGivenSeveralTimesAsOneHoweverItIsCutIntoTriangles) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const int n = std::array{5, 6, 8}[seed % 3];
    const int copies = 2 + static_cast<int>(seed % 2);
    std::vector<std::vector<int>> faces;
    add_fan(faces, floor_of_prism(n, 0), 0, true);
    for (int copy = 0; copy < copies; ++copy) {
      add_fan(faces, floor_of_prism(n, 1), random.below(n), random.below(2) == 1);
    }
    add_sides(faces, n, 0);
    if (seed % 4 >= 2) {  // in no order at all
      for (int i = static_cast<int>(faces.size()) - 1; i > 0; --i) {
        std::swap(faces[i], faces[random.below(i + 1)]);
      }
    }
    const RepairedModel model = sound_repair(soup(prism_corners(n, 2), faces));
    EXPECT_EQ(model.mesh.component_count, 1);
    EXPECT_EQ(model.mesh.face_count(), 2 * (n - 2) + 2 * n);
    EXPECT_EQ(border_edge_count(model.mesh), 0);
    EXPECT_NEAR(signed_volume(model.mesh), 9 * n * std::sin(2 * std::numbers::pi / n), 1e-9);
    EXPECT_EQ(build_dual_graph(model.mesh).panel_count(), n + 2);
    EXPECT_EQ(count_of(model, "dropped-duplicate-faces") + count_of(model, "merged-two-sided"),
              (copies - 1) * (n - 2));
  }
}

TEST(Repair, KeepsAWallBetweenRoomsThatIsCutIntoTrianglesTwoWays) {
  for (const int n : {4, 5, 8}) {
    std::vector<std::vector<int>> faces = {floor_of_prism(n, 2)};
    add_fan(faces, floor_of_prism(n, 0), 0, true);
    add_fan(faces, floor_of_prism(n, 1), 0, false);
    add_fan(faces, floor_of_prism(n, 1), 1, true);
    for (const int floor : {0, 1}) add_sides(faces, n, floor);
    const RepairedModel model = sound_repair(soup(prism_corners(n, 3), faces));
    EXPECT_EQ(model.mesh.component_count, 2);
    EXPECT_EQ(border_edge_count(model.mesh), 0);
    EXPECT_EQ(build_dual_graph(model.mesh).panel_count(), 2 * (n + 2));
  }
}

TEST(Repair, KeepsCrossingSheetsFlat) {
  // Two kites that cross along a diagonal of both, as quads and as triangles.
  const std::vector<Vec3> corners = {{0, 0, 0},    {15, 10, 0}, {0, 20, 0},
                                     {-15, 10, 0}, {0, 10, 15}, {0, 10, -15}};
  for (const auto& polygons : {std::vector<std::vector<int>>{{0, 1, 2, 3}, {0, 4, 2, 5}},
                               {{0, 1, 2}, {0, 2, 3}, {0, 4, 2}, {0, 2, 5}},
                               {{0, 1, 2}, {0, 3, 2}, {0, 4, 2}, {0, 5, 2}}}) {
    const RepairedModel model = sound_repair(soup(corners, polygons));
    const DualGraph graph = build_dual_graph(model.mesh);
    EXPECT_EQ(graph.panel_count(), 2);
    EXPECT_EQ(graph.hinge_count(), 0);
  }
}

TEST(Repair, ClosesACrackAndTellsItsWidth) {
  // The ridges of the tent's two panels lie 0.002 apart, the tent being 60 long.
  const RepairedModel model = sound_repair(soup({{0, 0, 0},
                                                 {60, 0, 0},
                                                 {60, 30, 25},
                                                 {0, 30, 25},
                                                 {60, 30, 25.002},
                                                 {0, 30, 25.002},
                                                 {60, 0, 50},
                                                 {0, 0, 50}},
                                                {{0, 1, 2, 3}, {5, 4, 6, 7}}));
  EXPECT_EQ(count_of(model, "closed-cracks"), 2);
  const Repair cracks = repair_named(model.repairs, "closed-cracks");
  ASSERT_EQ(cracks.parameters.size(), 1u);
  EXPECT_EQ(cracks.parameters[0].name, "width");
  EXPECT_NEAR(std::get<double>(cracks.parameters[0].value), 0.002, 1e-9);
  EXPECT_EQ(model.mesh.component_count, 1);
  EXPECT_EQ(build_dual_graph(model.mesh).panel_count(), 2);
}

TEST(Repair, TellsOfBodiesThatRunThroughEachOther) {
  const RepairedModel model = sound_repair(with(soup_of(cube()), soup_of(cube()), {0.5, 0.3, 0.2}));
  EXPECT_EQ(count_of(model, "crossing-bodies"), 1);
  EXPECT_EQ(count_of(sound_repair(with(soup_of(cube()), soup_of(cube()), {1, 0.3, 0})),
                     "crossing-bodies"),
            0);
}

TEST(Repair, ClosesTheCrackThatADegenerateFaceLeaves) {
  // A tetrahedron whose edge 0-1 has a third vertex 4 on it, bridged by the flat triangle 0 4 1.
  const RepairedModel model =
      sound_repair(soup({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {1, 0, 0}},
                        {{0, 2, 1}, {0, 4, 3}, {4, 1, 3}, {0, 3, 2}, {1, 2, 3}, {0, 1, 4}}));
  EXPECT_EQ(count_of(model, "dropped-degenerate-faces"), 1);
  EXPECT_EQ(count_of(model, "closed-t-junctions"), 1);
  EXPECT_EQ(border_edge_count(model.mesh), 0);
  EXPECT_EQ(std::count(model.mesh.source_faces.begin(), model.mesh.source_faces.end(), 0), 2);
}

TEST(Repair, TurnsFacesOutwards) {
  PolygonSoup spoilt = soup_of(star());
  std::swap(spoilt.corners[0], spoilt.corners[1]);
  EXPECT_EQ(count_of(sound_repair(spoilt), "flipped-faces"), 1);
  EXPECT_EQ(count_of(sound_repair(inside_out(soup_of(star()))), "flipped-faces"), 60);
}

TEST(Repair, FollowsTheMajorityOfAnOpenSurface) {
  const PolygonSoup strip = soup_of(open_strip(3));
  PolygonSoup spoilt = strip;
  std::swap(spoilt.corners[0], spoilt.corners[1]);
  const RepairedModel model = sound_repair(spoilt);
  EXPECT_EQ(count_of(model, "flipped-faces"), 1);
  const auto normal_z = [](const Mesh& mesh) {
    const auto& [a, b, c] = mesh.faces[3];
    return (mesh.positions[b] - mesh.positions[a]).cross(mesh.positions[c] - mesh.positions[a]).z();
  };
  EXPECT_GT(normal_z(model.mesh), 0);
  EXPECT_LT(normal_z(sound_repair(inside_out(spoilt)).mesh), 0);
}

TEST(Repair, CutsSurfacesWithOneSideOpen) {
  for (const int quads : {3, 4, 9, 24}) {
    const RepairedModel model = sound_repair(mobius_strip(quads));
    EXPECT_EQ(model.mesh.component_count, 1);
    EXPECT_EQ(model.mesh.face_count(), 2 * quads);
    EXPECT_GE(count_of(model, "cut-nonorientable"), 1);
    EXPECT_LE(count_of(model, "cut-nonorientable"), 2);
  }
}

TEST(Repair, TakesBodiesApartThatShareAnEdgeOrAVertex) {
  for (const bool turned : {false, true}) {
    const PolygonSoup one = turned ? inside_out(soup_of(cube())) : soup_of(cube());
    const RepairedModel at_edge = sound_repair(with(one, soup_of(cube()), {1, 1, 0}));
    EXPECT_EQ(at_edge.mesh.component_count, 2);
    EXPECT_EQ(border_edge_count(at_edge.mesh), 0);
    EXPECT_EQ(count_of(at_edge, "split-nonmanifold-edges"), 1);
    const RepairedModel at_vertex = sound_repair(with(one, soup_of(cube()), {1, 1, 1}));
    EXPECT_EQ(at_vertex.mesh.component_count, 2);
    EXPECT_EQ(count_of(at_vertex, "split-nonmanifold-vertices"), 1);
  }
}

TEST(Repair, KeepsTheWallBetweenTwoRooms) {
  // Two cubes side by side: their common wall has two sides.
  const RepairedModel model = sound_repair(with(soup_of(cube()), soup_of(cube()), {1, 0, 0}));
  EXPECT_EQ(model.mesh.component_count, 2);
  EXPECT_EQ(model.mesh.face_count(), 24);
  EXPECT_EQ(border_edge_count(model.mesh), 0);
}

TEST(Repair, LetsAFinGoFromAClosedBody) {
  PolygonSoup finned = soup_of(cube());
  finned.positions.emplace_back(0, 0, 0.2);  // within the cube, on the edge 0-1
  finned.corners.insert(finned.corners.end(), {0, 1, 8});
  finned.first_corner.push_back(static_cast<int>(finned.corners.size()));
  const RepairedModel model = sound_repair(finned);
  EXPECT_EQ(model.mesh.component_count, 2);
  EXPECT_EQ(border_edge_count(model.mesh), 3);
}

TEST(Repair, GivesTheSameTwice) {
  const RepairedModel first = repair(mobius_strip(12));
  const RepairedModel second = repair(mobius_strip(12));
  EXPECT_EQ(first.mesh.positions, second.mesh.positions);
  EXPECT_EQ(first.mesh.faces, second.mesh.faces);
}

TEST(Repair, MendsRandomSoups) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    // Few lattice points, so that faces coincide, touch and degenerate in every way.
    const int side = 2 + random.below(3);
    std::vector<Vec3> positions;
    for (int i = 0; i < side * side * side; ++i) {
      positions.emplace_back(i % side, i / side % side, i / side / side);
    }
    std::vector<std::vector<int>> polygons(1 + random.below(60));
    for (std::vector<int>& polygon : polygons) {
      const int corners = random.below(4) == 0 ? random.below(9) : 3;
      for (int i = 0; i < corners; ++i) {
        polygon.push_back(random.below(static_cast<int>(positions.size())));
      }
    }
    try {
      sound_repair(soup(positions, polygons));
    } catch (const InputError& error) {
      EXPECT_TRUE(error.code() == "no-area" || error.code() == "no-faces") << error.what();
    }
  }
}

}  // namespace
}  // namespace foldwright::testing
