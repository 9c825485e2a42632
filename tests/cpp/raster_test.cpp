#include "paper/raster.h"

#include <gtest/gtest.h>

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

TEST(SheetRaster, FindsTheHighestPlaceAndThenTheLeftmost) {
  const PieceRaster square = rasterize({{{0, 0}, {3, 0}, {3, 3}, {0, 3}}}, {3, 3});
  SheetRaster sheet({10, 8});
  const CellPlace expected[] = {{0, 0}, {4, 0}, {0, 4}, {4, 4}};
  for (const CellPlace& cell : expected) {
    const auto place = sheet.find(square, sheet.row_count());
    ASSERT_TRUE(place);
    EXPECT_EQ(place->x, cell.x);
    EXPECT_EQ(place->y, cell.y);
    sheet.take(square, *place, 1);
  }
  EXPECT_FALSE(sheet.find(square, sheet.row_count()));
}

TEST(SheetRaster, LooksOnlyAboveTheRowItIsTold) {
  const PieceRaster square = rasterize({{{0, 0}, {3, 0}, {3, 3}, {0, 3}}}, {3, 3});
  SheetRaster sheet({3, 20});
  sheet.take(square, {0, 0}, 2);
  EXPECT_FALSE(sheet.find(square, 5));
  EXPECT_EQ(sheet.find(square, 6)->y, 5);
}

TEST(SheetRaster, WorksAcrossWordsOfBits) {
  const PieceRaster bar = rasterize({{{0, 0}, {130, 0}, {130, 1}, {0, 1}}}, {130, 1});
  SheetRaster sheet({200, 3});
  sheet.take(rasterize({{{0, 0}, {2, 0}, {2, 1}, {0, 1}}}, {2, 1}), {67, 0}, 0);
  EXPECT_EQ(sheet.find(bar, 1)->x, 69);
  sheet.take(rasterize({{{0, 0}, {2, 0}, {2, 1}, {0, 1}}}, {2, 1}), {150, 0}, 0);
  EXPECT_FALSE(sheet.find(bar, 1));
  EXPECT_EQ(sheet.find(bar, 2)->x, 0);
}

TEST(SheetRaster, HoldsAPieceThatJustFits) {
  const PieceRaster whole = rasterize({{{0, 0}, {9.7, 0}, {9.7, 7.3}, {0, 7.3}}}, {9.7, 7.3});
  SheetRaster sheet({9.7, 7.3});
  ASSERT_TRUE(sheet.find(whole, sheet.row_count()));
  sheet.take(whole, {0, 0}, 3);
  EXPECT_FALSE(sheet.find(whole, sheet.row_count()));
}

}  // namespace
}  // namespace foldwright::testing
