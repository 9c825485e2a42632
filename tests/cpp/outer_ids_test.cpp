#include "paper/outer_ids.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "data_files.h"
#include "geometry/convex2.h"
#include "job_runs.h"
#include "shared_models.h"

namespace foldwright::testing {
namespace {

std::vector<Vec2> square(double x, double y, double size) {
  return {{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}};
}

Surroundings around_square(double size, double neighbour_at) {
  Surroundings around{{}, {{-50, -50}, {100, 100}}};
  for (const auto& polygon : {square(0, 0, size), square(neighbour_at, 0, size)}) {
    around.obstacles.push_back({polygon, box_of(polygon), 0});
  }
  return around;
}

constexpr double kEasy[] = {3, 2};

TEST(OuterIds, StandAlongTheEdgeOutsideOfThePiece) {
  const Surroundings around = around_square(30, 60);
  const OuterIdFinder finder(around);
  const Stroke right = {{30, 0}, {30, 30}};
  const auto found = finder.beside(right, "C3", kEasy);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->size, 3);
  EXPECT_GT(found->box.centre.x(), 30);
  EXPECT_LT(found->box.centre.x(), 33);
  EXPECT_NEAR(found->box.centre.y(), 15, 1e-6);
  for (const Vec2& corner : found->box.corners()) EXPECT_GE(corner.x(), 30);
}

TEST(OuterIds, StandBesideEachOther) {
  const Surroundings around = around_square(30, 60);
  OuterIdFinder finder(around);
  const Stroke right = {{30, 0}, {30, 30}};
  std::vector<TextBox> boxes;
  for (int i = 0; i < 3; ++i) {
    const auto found = finder.beside(right, "C3", kEasy);
    ASSERT_TRUE(found);
    for (const TextBox& other : boxes) {
      EXPECT_FALSE(convex_overlap(other.corners(), found->box.corners(), 0));
    }
    finder.take(found->box);
    boxes.push_back(found->box);
  }
}

TEST(OuterIds, OfShortEdgesStandApartWithALine) {
  const Surroundings around = around_square(2, 60);
  const OuterIdFinder finder(around);
  const Stroke right = {{2, 0}, {2, 2}};
  EXPECT_FALSE(finder.beside(right, "C13", kEasy));
  const auto found = finder.apart(right, "C13", kEasy);
  ASSERT_TRUE(found);
  EXPECT_GT(found->box.centre.x(), 2);
  EXPECT_NEAR((found->leader.to - Vec2(2, 1)).norm(), 0.3, 1e-9);
  EXPECT_LT((found->leader.from - found->leader.to).norm(), 12);
}

TEST(OuterIds, NeedRoomOnThePaper) {
  const Stroke right = {{30, 0}, {30, 30}};
  const Surroundings crowded = around_square(30, 31);
  EXPECT_FALSE(OuterIdFinder(crowded).beside(right, "C3", kEasy));
  EXPECT_FALSE(OuterIdFinder(crowded).apart(right, "C3", kEasy));
  Surroundings at_the_edge = around_square(30, 60);
  at_the_edge.paper.max[0] = 31;
  EXPECT_FALSE(OuterIdFinder(at_the_edge).beside(right, "C3", kEasy));
}

/// Polygons of faces and flaps of all pieces on a sheet, from its lower left.
std::vector<std::vector<Vec2>> polygons_on(const JobResult& result, int sheet) {
  std::vector<std::vector<Vec2>> polygons;
  for (std::size_t i = 0; i < result.pieces.size(); ++i) {
    const Placement& place = result.sheets.placements[i];
    if (place.sheet != sheet) continue;
    const Vec2 origin(place.x, place.y);
    const Net& net = result.pieces[i].net;
    for (const auto& [a, b, c] : net.corners) {
      polygons.push_back(
          {net.vertices[a] + origin, net.vertices[b] + origin, net.vertices[c] + origin});
    }
  }
  return polygons;
}

TEST(OuterIds, OfAJobLieOnNoFace) {
  for (const auto& file : corpus_files()) {
    const std::string name = file.filename().string();
    SCOPED_TRACE(name);
    JobOptions options{.nets = {.compaction = false}, .paper = {.ids = IdPlace::kOutside}};
    const Outcome outcome = run_file(bytes_of(file), name, options);
    expect_sound(outcome);
    int on_faces = 0;
    int numbers = 0;
    for (std::size_t i = 0; i < outcome.result->pieces.size(); ++i) {
      const Piece& piece = outcome.result->pieces[i];
      const Placement& place = outcome.result->sheets.placements[i];
      const auto polygons = polygons_on(*outcome.result, place.sheet);
      for (const Label& label : piece.labels) {
        if (label.text == piece.name) continue;
        ++numbers;
        const Vec2 along(std::cos(label.angle), std::sin(label.angle));
        const auto box = box_around(label.text, {label.size}, label.centre, along).corners();
        std::vector<Vec2> text;
        for (const Vec2& p : box) text.push_back(p + Vec2(place.x, place.y));
        on_faces += std::ranges::any_of(
            polygons, [&](const auto& polygon) { return convex_overlap(text, polygon, 0); });
      }
    }
    EXPECT_GT(numbers, 0);
    // Slits and notches of the net itself have no room for some.
    EXPECT_LE(on_faces, numbers / 5);
  }
}

}  // namespace
}  // namespace foldwright::testing
