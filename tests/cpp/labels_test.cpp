#include "segment/labels.h"

#include <gtest/gtest.h>

#include "meshes.h"

namespace foldwright::testing {
namespace {

TEST(Labels, AreRenumberedByFirstAppearance) {
  EXPECT_EQ(renumbered(std::vector<int>{7, 7, 0, 3, 0, 9}), (Labels{0, 0, 1, 2, 1, 3}));
  EXPECT_EQ(renumbered(std::vector<int>{}), Labels{});
}

TEST(Labels, CountTheParts) {
  EXPECT_EQ(part_count(Labels{0, 2, 1, 2}), 3);
  EXPECT_EQ(part_count(Labels{}), 0);
}

TEST(Labels, PiecesOfPartsAreTheirConnectedRuns) {
  const DualGraph row = build_dual_graph(accordion(std::vector<double>(7, 1)));
  EXPECT_EQ(part_pieces(row, Labels{0, 0, 1, 0, 0, 2, 2}), (std::vector<int>{0, 0, 1, 2, 2, 3, 3}));
  EXPECT_EQ(part_pieces(row, Labels(7, 0)), std::vector<int>(7, 0));
}

}  // namespace
}  // namespace foldwright::testing
