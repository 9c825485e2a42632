#include "paper/raster.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>

#include "geometry/random.h"

namespace foldwright::testing {
namespace {

const std::vector<std::vector<Vec2>> kTriangle = {{{0, 0}, {4, 0}, {0, 4}}};

TEST(Rasterize, TakesAllCellsThatAreTouched) {
  const PieceRaster raster = rasterize(kTriangle, {4, 4});
  ASSERT_EQ(raster.rows.size(), 4u);
  for (int row = 0; row < 4; ++row) {
    ASSERT_EQ(raster.rows[row].size(), 1u);
    EXPECT_EQ(raster.rows[row][0].from, 0);
    EXPECT_EQ(raster.rows[row][0].length, row + 1) << "from the top";
  }
}

TEST(Rasterize, KeepsHolesFree) {
  const PieceRaster raster =
      rasterize({{{0, 0}, {1, 0}, {1, 3}, {0, 3}}, {{4, 0}, {5, 0}, {5, 3}, {4, 3}}}, {5, 3});
  for (const auto& runs : raster.rows) EXPECT_EQ(runs.size(), 2u);
}

TEST(PlaceFinder, FindsTheHighestPlaceAndThenTheLeftmost) {
  const PieceRaster square = rasterize({{{0, 0}, {3, 0}, {3, 3}, {0, 3}}}, {3, 3});
  SheetRaster sheet({10, 8});
  const CellPlace expected[] = {{0, 0}, {4, 0}, {0, 4}, {4, 4}};
  for (const CellPlace& cell : expected) {
    const auto place = PlaceFinder(sheet).find(square, sheet.row_count());
    ASSERT_TRUE(place);
    EXPECT_EQ(place->x, cell.x);
    EXPECT_EQ(place->y, cell.y);
    sheet.take(square, *place, 1);
  }
  EXPECT_FALSE(PlaceFinder(sheet).find(square, sheet.row_count()));
}

TEST(PlaceFinder, LooksOnlyAboveTheRowItIsTold) {
  const PieceRaster square = rasterize({{{0, 0}, {3, 0}, {3, 3}, {0, 3}}}, {3, 3});
  SheetRaster sheet({3, 20});
  sheet.take(square, {0, 0}, 2);
  EXPECT_FALSE(PlaceFinder(sheet).find(square, 5));
  EXPECT_EQ(PlaceFinder(sheet).find(square, 6)->y, 5);
}

TEST(PlaceFinder, WorksAcrossWordsOfBits) {
  const PieceRaster bar = rasterize({{{0, 0}, {130, 0}, {130, 1}, {0, 1}}}, {130, 1});
  SheetRaster sheet({200, 3});
  sheet.take(rasterize({{{0, 0}, {2, 0}, {2, 1}, {0, 1}}}, {2, 1}), {67, 0}, 0);
  EXPECT_EQ(PlaceFinder(sheet).find(bar, 1)->x, 69);
  sheet.take(rasterize({{{0, 0}, {2, 0}, {2, 1}, {0, 1}}}, {2, 1}), {150, 0}, 0);
  EXPECT_FALSE(PlaceFinder(sheet).find(bar, 1));
  EXPECT_EQ(PlaceFinder(sheet).find(bar, 2)->x, 0);
}

/// A triangle with corners anywhere in a box.
PieceRaster any_triangle(Random& random, int most) {
  const auto any = [&] {
    return Vec2(0.125 * random.below(8 * most), 0.125 * random.below(8 * most));
  };
  std::vector<Vec2> corners = {any(), any(), any()};
  if (cross(corners[1] - corners[0], corners[2] - corners[0]) < 0)
    std::swap(corners[0], corners[1]);
  const Vec2 low = corners[0].cwiseMin(corners[1]).cwiseMin(corners[2]);
  for (Vec2& p : corners) p -= low;
  const Vec2 high = corners[0].cwiseMax(corners[1]).cwiseMax(corners[2]);
  return rasterize({corners}, {high.x(), high.y()});
}

TEST(PlaceFinder, FindsWhatTryingAllPlacesFinds) {
  constexpr int kWidth = 150;
  constexpr int kHeight = 60;
  Random random(3);
  SheetRaster sheet({kWidth, kHeight});
  std::set<std::pair<int, int>> taken;
  const auto cells_of = [](const PieceRaster& piece, int x, int y) {
    std::vector<std::pair<int, int>> cells;
    for (int r = 0; r < static_cast<int>(piece.rows.size()); ++r) {
      for (const auto& [from, length] : piece.rows[r]) {
        for (int i = 0; i < length; ++i) cells.emplace_back(x + from + i, y + r);
      }
    }
    return cells;
  };
  const auto try_all = [&](const PieceRaster& piece) -> std::optional<std::pair<int, int>> {
    for (int y = 0; y + piece.box.height <= kHeight; ++y) {
      for (int x = 0; x + piece.box.width <= kWidth; ++x) {
        const auto is_taken = [&](const auto& cell) { return taken.contains(cell); };
        if (std::ranges::none_of(cells_of(piece, x, y), is_taken)) return std::pair(x, y);
      }
    }
    return std::nullopt;
  };
  int refused = 0;
  for (int round = 0; round < 150; ++round) {
    const PieceRaster piece = any_triangle(random, round % 3 == 0 ? 60 : 20);
    const auto expected = try_all(piece);
    const auto place = PlaceFinder(sheet).find(piece, sheet.row_count());
    ASSERT_EQ(place.has_value(), expected.has_value()) << round;
    refused += !place;
    if (!place) continue;
    EXPECT_EQ(std::pair(place->x, place->y), *expected) << round;
    sheet.take(piece, *place, 0);
    for (const auto& cell : cells_of(piece, place->x, place->y)) taken.insert(cell);
  }
  EXPECT_GT(refused, 5);
  EXPECT_LT(refused, 140);
}

TEST(SheetRaster, HoldsAPieceThatJustFits) {
  const PieceRaster whole = rasterize({{{0, 0}, {9.7, 0}, {9.7, 7.3}, {0, 7.3}}}, {9.7, 7.3});
  SheetRaster sheet({9.7, 7.3});
  ASSERT_TRUE(PlaceFinder(sheet).find(whole, sheet.row_count()));
  sheet.take(whole, {0, 0}, 3);
  EXPECT_FALSE(PlaceFinder(sheet).find(whole, sheet.row_count()));
}

}  // namespace
}  // namespace foldwright::testing
