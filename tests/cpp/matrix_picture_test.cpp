#include "pipeline/parts/matrix_picture.h"

#include <gtest/gtest.h>

namespace foldwright {
namespace {

/// 1 within each of two interleaved groups, 0 between them.
FoldabilityMatrix two_groups(int size) {
  FoldabilityMatrix matrix{size, {}};
  for (int i = 0; i < size; ++i) {
    for (int j = 0; j < size; ++j) matrix.values.push_back(i % 2 == j % 2 ? 1.0f : 0.0f);
  }
  return matrix;
}

TEST(MatrixPicture, ShowsASmallMatrixAsItIs) {
  const MatrixPicture picture = make_matrix_picture({2, {1.0f, 0.5f, 0.5f, 1.0f}});
  EXPECT_EQ(picture.size, 2);
  EXPECT_EQ(picture.values, (std::vector<std::uint8_t>{255, 128, 128, 255}));
  EXPECT_TRUE(picture.blocks.empty());
}

TEST(MatrixPicture, SortsRowsIntoTheBlocksOfTheParts) {
  const std::vector<int> labels = {0, 1, 0, 1};
  const MatrixPicture picture = make_matrix_picture(two_groups(4), labels);
  EXPECT_EQ(picture.blocks, (std::vector<int>{0, 2}));
  EXPECT_EQ(picture.values, (std::vector<std::uint8_t>{255, 255, 0, 0, 255, 255, 0, 0,  //
                                                       0, 0, 255, 255, 0, 0, 255, 255}));
}

TEST(MatrixPicture, AveragesALargeMatrixDown) {
  const MatrixPicture picture = make_matrix_picture(two_groups(1024));
  EXPECT_EQ(picture.size, 256);
  ASSERT_EQ(picture.values.size(), 256u * 256u);
  // Every cell averages four rows and columns, half of them alike.
  for (const std::uint8_t value : picture.values) EXPECT_EQ(value, 128);
}

}  // namespace
}  // namespace foldwright
