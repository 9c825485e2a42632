#include "paper/rows.h"

#include <gtest/gtest.h>

namespace foldwright::testing {
namespace {

TEST(LayInRows, PutsHighBoxesFirstAndFillsFromTheTop) {
  const std::vector<Extent> boxes = {{4, 1}, {4, 3}, {5, 2}};
  const RowLayout rows = lay_in_rows(boxes, {10, 10}, 1);
  EXPECT_EQ(rows.sheet_count, 1);
  EXPECT_EQ(rows.places[1].x, 0);
  EXPECT_EQ(rows.places[1].y, 7);
  EXPECT_EQ(rows.places[2].x, 5);
  EXPECT_EQ(rows.places[2].y, 8);
  EXPECT_EQ(rows.places[0].y, 5) << "a row of its own below";
}

TEST(LayInRows, OpensAnotherSheetWhereOneIsFull) {
  const std::vector<Extent> boxes(5, Extent{6, 6});
  const RowLayout rows = lay_in_rows(boxes, {10, 13}, 1);
  EXPECT_EQ(rows.sheet_count, 3);
  EXPECT_EQ(rows.places[4].sheet, 2);
}

}  // namespace
}  // namespace foldwright::testing
