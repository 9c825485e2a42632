#include "repair/fill_holes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "meshes.h"
#include "model_text.h"
#include "repair/repair.h"
#include "sound_repair.h"

namespace foldwright::testing {
namespace {

constexpr double kAll = 2;

/// The polygons of a soup but for those whose corners are all chosen by their place.
template <class Choose>
PolygonSoup without(const PolygonSoup& whole, Choose&& is_chosen) {
  std::vector<std::vector<int>> polygons;
  for (int f = 0; f < whole.face_count(); ++f) {
    const std::vector<int> corners = corners_of(whole, f);
    const bool is_dropped = std::ranges::all_of(
        corners, [&](int corner) { return is_chosen(whole.positions[corner]); });
    if (!is_dropped) polygons.push_back(corners);
  }
  return soup(whole.positions, polygons);
}

bool is_above(const Vec3& p) { return p.y() > 0; }

/// A unit cube without its upper side.
PolygonSoup open_box() { return without(soup_of(cube()), is_above); }

/// The soup with the faces of another one.
PolygonSoup with(PolygonSoup whole, const PolygonSoup& more) {
  const int offset = static_cast<int>(whole.positions.size());
  whole.positions.insert(whole.positions.end(), more.positions.begin(), more.positions.end());
  for (const int corner : more.corners) whole.corners.push_back(corner + offset);
  const int first = whole.first_corner.back();
  for (int f = 1; f <= more.face_count(); ++f) {
    whole.first_corner.push_back(first + more.first_corner[f]);
  }
  return whole;
}

PolygonSoup scaled(PolygonSoup whole, const Vec3& by) {
  for (Vec3& p : whole.positions) p = p.cwiseProduct(by);
  return whole;
}

/// Repairs with holes up to this share of the longest side filled.
RepairedModel filled(const PolygonSoup& soup, double fill_holes) {
  return sound_repair(soup, {.fill_holes = fill_holes});
}

int filling_faces(const RepairedModel& model) {
  return static_cast<int>(std::ranges::count(model.mesh.source_faces, -1));
}

/// A cylinder without lids, radius 1 and height `height`, whose upper rim goes up and down.
PolygonSoup open_cup(int around, double height, double wave) {
  std::vector<Vec3> positions;
  std::vector<std::vector<int>> polygons;
  std::vector<int> bottom;
  for (int i = 0; i < around; ++i) {
    const double angle = 2 * std::numbers::pi * i / around;
    positions.emplace_back(std::cos(angle), 0, -std::sin(angle));
    positions.emplace_back(std::cos(angle), height + wave * std::sin(3 * angle), -std::sin(angle));
  }
  for (int i = 0; i < around; ++i) {
    const int next = (i + 1) % around;
    polygons.push_back({2 * i, 2 * next, 2 * next + 1});
    polygons.push_back({2 * i, 2 * next + 1, 2 * i + 1});
    bottom.push_back(2 * (around - 1 - i));
  }
  polygons.push_back(bottom);
  return soup(positions, polygons);
}

TEST(FillHoles, LeavesHolesOpenUnlessAsked) {
  const RepairedModel model = filled(open_box(), 0);
  EXPECT_EQ(model.mesh.face_count(), 10);
  EXPECT_EQ(count_of(model, "open-holes"), 1);
  EXPECT_EQ(count_of(model, "open-border"), 4);
  EXPECT_EQ(count_of(model, "filled-holes"), 0);
}

TEST(FillHoles, MakesABoxWithAHoleTheBoxAgain) {
  const RepairedModel model = filled(open_box(), kAll);
  EXPECT_EQ(count_of(model, "filled-holes"), 1);
  EXPECT_EQ(count_of(model, "open-holes"), 0);
  EXPECT_EQ(count_of(model, "open-border"), 0);
  EXPECT_EQ(count_of(model, "flipped-faces"), 0);
  EXPECT_EQ(filling_faces(model), 2);
  EXPECT_NEAR(signed_volume(model.mesh), 1, 1e-12);
}

TEST(FillHoles, FillsAHoleWithARimThatIsNotFlat) {
  const PolygonSoup cup = open_cup(20, 2, 0.3);
  EXPECT_EQ(count_of(filled(cup, 0), "open-border"), 20);
  const RepairedModel model = filled(cup, kAll);
  EXPECT_EQ(count_of(model, "filled-holes"), 1);
  EXPECT_EQ(border_edge_count(model.mesh), 0);
  EXPECT_EQ(filling_faces(model), 18);
  // Below and above the rim's mean height as much.
  EXPECT_NEAR(signed_volume(model.mesh), 10 * std::sin(2 * std::numbers::pi / 20) * 2, 0.1);
}

TEST(FillHoles, FillsTheNarrowOfTwoHolesOnly) {
  // A box without an end (1 x 1) and without the side above (4 x 1), but for a bridge between them.
  const std::vector<Vec3> positions = {{0, 0, 0}, {4, 0, 0}, {4, 0, 1}, {0, 0, 1}, {0, 1, 0},
                                       {4, 1, 0}, {4, 1, 1}, {0, 1, 1}, {3, 1, 0}, {3, 1, 1}};
  const PolygonSoup open =
      soup(positions, {{0, 1, 2, 3}, {0, 4, 8, 5, 1}, {3, 2, 6, 9, 7}, {0, 3, 7, 4}, {8, 9, 6, 5}});
  const RepairedModel narrow = filled(open, 0.4);
  EXPECT_EQ(count_of(narrow, "filled-holes"), 1);
  EXPECT_EQ(count_of(narrow, "open-holes"), 1);
  EXPECT_EQ(border_edge_count(narrow.mesh), 4);
  const RepairedModel both = filled(open, kAll);
  EXPECT_EQ(count_of(both, "filled-holes"), 2);
  EXPECT_NEAR(signed_volume(both.mesh), 4, 1e-12);
}

TEST(FillHoles, FillsHolesThatTouchInAVertex) {
  // Without two triangles that share one vertex only.
  const Mesh whole = icosahedron();
  const auto shared = [&](const std::array<int, 3>& face) {
    return std::ranges::count_if(face,
                                 [&](int v) { return std::ranges::count(whole.faces[0], v) > 0; });
  };
  const auto touching =
      std::ranges::find_if(whole.faces, [&](const auto& face) { return shared(face) == 1; });
  std::vector<std::vector<int>> polygons;
  for (const auto& face : whole.faces) {
    if (face == whole.faces[0] || face == *touching) continue;
    polygons.push_back({face.begin(), face.end()});
  }
  const RepairedModel model = filled(soup(whole.positions, polygons), kAll);
  EXPECT_EQ(count_of(model, "filled-holes"), 2);
  EXPECT_EQ(border_edge_count(model.mesh), 0);
  EXPECT_EQ(model.mesh.vertex_count(), whole.vertex_count());
  EXPECT_NEAR(signed_volume(model.mesh), signed_volume(whole), 1e-12);
}

TEST(FillHoles, WindsWhatItClosesOutwards) {
  PolygonSoup open = open_box();
  std::vector<std::vector<int>> polygons;
  for (int f = 0; f < open.face_count(); ++f) {
    polygons.push_back(corners_of(open, f));
    std::reverse(polygons.back().begin(), polygons.back().end());
  }
  const RepairedModel model = filled(soup(open.positions, polygons), kAll);
  EXPECT_EQ(count_of(model, "flipped-faces"), 10);  // those of the file, not what fills the hole
  EXPECT_NEAR(signed_volume(model.mesh), 1, 1e-12);
}

TEST(FillHoles, RefusesTheRimsOfFlatSheets) {
  for (const Mesh& sheet : {open_strip(1), open_strip(5)}) {
    const RepairedModel asked = filled(soup_of(sheet), kAll);
    EXPECT_EQ(asked.mesh.face_count(), sheet.face_count());
    EXPECT_EQ(count_of(asked, "unfilled-holes"), 1);
    EXPECT_EQ(count_of(filled(soup_of(sheet), 0), "open-holes"), 0);
  }
  EXPECT_EQ(count_of(filled(soup({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}), kAll),
                     "unfilled-holes"),
            1);
}

TEST(FillHoles, LeavesHolesOfTooManyEdgesOpen) {
  // A fan of triangles around one vertex: its border is the hole.
  constexpr int kCount = kMostHoleEdges + 1;
  std::vector<Vec3> positions = {{0, 0, 1}};
  std::vector<std::vector<int>> polygons;
  for (int i = 0; i < kCount; ++i) {
    const double angle = 2 * std::numbers::pi * i / kCount;
    positions.push_back({std::cos(angle), std::sin(angle), 0});
    polygons.push_back({0, 1 + i, 1 + (i + 1) % kCount});
  }
  const RepairedModel model = filled(soup(positions, polygons), kAll);
  EXPECT_EQ(count_of(model, "huge-holes"), 1);
  EXPECT_EQ(count_of(model, "filled-holes"), 0);
}

TEST(FillHoles, RefusesToRunThroughTheModel) {
  // A stick that stands in the hole of a box.
  const PolygonSoup stick = scaled(soup_of(cube()), {0.2, 3, 0.2});
  const RepairedModel model = filled(with(open_box(), stick), kAll);
  EXPECT_EQ(count_of(model, "filled-holes"), 0);
  EXPECT_EQ(count_of(model, "unfilled-holes"), 1);
  EXPECT_EQ(border_edge_count(model.mesh), 4);
}

TEST(FillHoles, TakesTheColoursBesideTheHole) {
  PolygonSoup open = open_box();
  for (std::size_t i = 0; i < open.corners.size(); ++i) open.looks.colours.push_back({10, 20, 30});
  for (int f = 0; f < open.face_count(); ++f) open.looks.materials.push_back(f);
  const RepairedModel model = filled(open, kAll);
  const FaceLooks looks = carry_looks(open.looks, open.first_corner, model.origins);
  for (const Rgb& colour : looks.colours) EXPECT_EQ(colour, (Rgb{10, 20, 30}));
  for (int f = 0; f < model.mesh.face_count(); ++f) {
    if (model.mesh.source_faces[f] != -1) continue;
    // That of a face that shares an edge with it.
    std::vector<int> beside;
    for (const int edge : model.mesh.face_edges[f]) {
      for (const int other : model.mesh.edges[edge].faces) {
        beside.push_back(model.mesh.source_faces[other]);
      }
    }
    EXPECT_EQ(std::ranges::count(beside, looks.materials[f]), 1);
  }
}

}  // namespace
}  // namespace foldwright::testing
