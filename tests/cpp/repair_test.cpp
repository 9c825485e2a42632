#include "repair/repair.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "mesh/dual_graph.h"
#include "meshes.h"
#include "model_text.h"
#include "random_soup.h"
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
    try {
      sound_repair(random_soup(seed));
    } catch (const InputError& error) {
      EXPECT_TRUE(error.code() == "no-area" || error.code() == "no-faces") << error.what();
    }
  }
}

}  // namespace
}  // namespace foldwright::testing
