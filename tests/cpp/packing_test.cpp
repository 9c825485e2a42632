#include "paper/packing.h"

#include <gtest/gtest.h>

#include <cmath>

#include "geometry/convex2.h"
#include "geometry/random.h"

namespace foldwright::testing {
namespace {

Footprint rectangle(double width, double height) {
  return {{{Vec2(0, 0), Vec2(width, 0), Vec2(width, height), Vec2(0, height)}}, width * height};
}

Packing pack(const PackingTask& task) {
  Packer packer(task);
  while (!packer.step()) {
  }
  return packer.take();
}

std::vector<Vec2> placed(const Footprint& piece, const Packing& packing, std::size_t i) {
  std::vector<Vec2> corners;
  for (const Vec2& p : piece.polygons[0]) {
    corners.push_back(packing.turns[i](p) + Vec2(packing.placements[i].x, packing.placements[i].y));
  }
  return corners;
}

void expect_apart(const std::vector<Footprint>& pieces, const Packing& packing) {
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (packing.placements[i].sheet != packing.placements[j].sheet) continue;
      EXPECT_FALSE(convex_overlap(placed(pieces[i], packing, i), placed(pieces[j], packing, j), 0));
    }
  }
}

/// A rectangle with the grain of its sides, lying aslant.
Footprint slanted(double width, double height, double angle) {
  Footprint piece = rectangle(width, height);
  for (Vec2& p : piece.polygons[0]) {
    p = Vec2(std::cos(angle) * p.x() - std::sin(angle) * p.y(),
             std::sin(angle) * p.x() + std::cos(angle) * p.y());
  }
  piece.grain = angle;
  return piece;
}

TEST(Packer, LaysPiecesAlongTheirGrain) {
  // Across the room the strip would end higher.
  const std::vector<Footprint> pieces = {slanted(200, 10, 0.3), slanted(50, 40, 1.2)};
  for (const int effort : {1, 60}) {
    const Packing packing = pack({.pieces = pieces, .room = {190, 250}, .effort = effort});
    EXPECT_EQ(packing.sheet_count, 1);
    EXPECT_EQ(packing.aslant, 0);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      EXPECT_FALSE(lies_aslant(pieces[i], packing.turns[i])) << i;
    }
    expect_apart(pieces, packing);
  }
}

TEST(Packer, LaysPiecesAslantWhereThatSavesASheet) {
  const std::vector<Footprint> pieces = {slanted(230, 10, 0.3)};
  const Packing packing = pack({.pieces = pieces, .room = {190, 190}});
  EXPECT_EQ(packing.sheet_count, 1);
  EXPECT_EQ(packing.aslant, 1);
}

TEST(Packer, FindsWithMoreEffortNothingWorse) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    std::vector<Footprint> pieces;
    for (int i = 0; i < 9; ++i) {
      pieces.push_back(rectangle(20 + 70 * random.uniform(), 20 + 70 * random.uniform()));
    }
    PackingTask task = {.pieces = pieces, .room = {190, 150}};
    const auto paper = [](const Packing& p) { return 150 * (p.sheet_count - 1) + p.used_height; };
    task.effort = 1;
    const double hurried = paper(pack(task));
    task.effort = 4;
    const double some = paper(pack(task));
    task.effort = 60;
    const Packing most = pack(task);
    EXPECT_LE(some, hurried + 1e-9);
    EXPECT_LE(paper(most), some + 1e-9);
    expect_apart(pieces, most);
  }
}

TEST(Packer, KeepsPartsTogetherWhereItCostsNothing) {
  // Four squares, of which two go on a sheet, in whatever pairs.
  const std::vector<Footprint> pieces(4, rectangle(80, 80));
  const std::vector<int> parts = {0, 1, 0, 1};
  const Packing packing = pack({.pieces = pieces, .room = {170, 90}, .parts = parts});
  EXPECT_EQ(packing.sheet_count, 2);
  EXPECT_EQ(packing.placements[0].sheet, packing.placements[2].sheet);
  EXPECT_EQ(packing.placements[1].sheet, packing.placements[3].sheet);
}

TEST(Packer, PacksAroundPins) {
  const std::vector<Footprint> pieces(4, rectangle(60, 40));
  const std::vector<std::optional<Pin>> pins = {std::nullopt, Pin{{0, 30, 70}, 0.5}, std::nullopt,
                                                std::nullopt};
  const Packing packing = pack({.pieces = pieces, .room = {190, 277}, .pins = pins});
  EXPECT_EQ(packing.placements[1].sheet, 0);
  EXPECT_EQ(packing.placements[1].x, 30);
  EXPECT_EQ(packing.placements[1].y, 70);
  EXPECT_NEAR(packing.turns[1].s, std::sin(0.5), 1e-12);
  EXPECT_EQ(packing.sheet_count, 1);
  expect_apart(pieces, packing);
}

TEST(Packer, RefusesAPieceThatFitsNoSheetInsteadOfAddingSheetsForEver) {
  const std::vector<Footprint> pieces = {rectangle(50, 50), rectangle(300, 300)};
  EXPECT_THROW(pack({.pieces = pieces, .room = {190, 150}}), std::logic_error);
}

TEST(Packer, TakesPiecesThatExceedLargePaperByRounding) {
  const double side = 9000 + 0.9 * kFitTolerance;
  const std::vector<Footprint> pieces = {rectangle(side, side)};
  EXPECT_EQ(pack({.pieces = pieces, .room = {9000, 9000}, .effort = 1}).sheet_count, 1);
}

TEST(Packer, PutsHundredsOfPiecesOnAsManySheets) {
  // Each order of pieces once kept a copy of all sheets for every piece.
  const std::vector<Footprint> pieces(400, rectangle(150, 120));
  const Packing packing = pack({.pieces = pieces, .room = {190, 150}});
  EXPECT_EQ(packing.sheet_count, 400);
}

}  // namespace
}  // namespace foldwright::testing
