#include "paper/flap_sides.h"

#include <gtest/gtest.h>

namespace foldwright::testing {
namespace {

/// The sides of a chain of seams whose first bank is their first side.
std::vector<int> sides_of(const std::vector<SideHeights>& heights) {
  std::vector<std::vector<SeamStep>> chains(1);
  for (int i = 0; i < static_cast<int>(heights.size()); ++i) chains[0].push_back({i, 0});
  return sides_in_chains(chains, heights, 5, kChangeBetween);
}

TEST(SidesInChains, StayOnOneBankForALittleHeight) {
  EXPECT_EQ(sides_of({{5, 5}, {4, 5}, {5, 3}, {5, 5}}), (std::vector<int>{0, 0, 0, 0}));
  EXPECT_EQ(sides_of({{5, 5}, {3, 5}, {3, 5}, {5, 5}}), (std::vector<int>{1, 1, 1, 1}));
}

TEST(SidesInChains, ChangeWhereAFlapWouldBeLost) {
  EXPECT_EQ(sides_of({{5, 0}, {5, 0}, {0, 5}, {5, 0}}), (std::vector<int>{0, 0, 1, 0}));
}

TEST(SidesInChains, KeepOffSidesThatMayHaveNone) {
  EXPECT_EQ(sides_of({{5, 5}, {-1, 2}, {5, 5}}), (std::vector<int>{1, 1, 1}));
}

TEST(SidesInChains, FollowBanksNotSides) {
  const std::vector<std::vector<SeamStep>> chain = {{{0, 0}, {1, 1}, {2, 0}}};
  const std::vector<SideHeights> heights = {{5, 0}, {5, 5}, {5, 4}};
  EXPECT_EQ(sides_in_chains(chain, heights, 5, kChangeBetween), (std::vector<int>{0, 1, 0}));
}

TEST(SidesInChains, WithinAPieceOnlyEqualsStayTogether) {
  const std::vector<std::vector<SeamStep>> chain = {{{0, 0}, {1, 0}, {2, 0}}};
  const auto sides = [&](const std::vector<SideHeights>& heights) {
    return sides_in_chains(chain, heights, 5, kChangeWithin);
  };
  EXPECT_EQ(sides({{5, 5}, {4, 5}, {5, 5}}), (std::vector<int>{1, 1, 1}));
  EXPECT_EQ(sides({{5, 4}, {4, 5}, {5, 4}}), (std::vector<int>{0, 1, 0}));
}

TEST(SidesInChains, TakeTheHigherSideOutsideOfChains) {
  EXPECT_EQ(
      sides_in_chains({}, std::vector<SideHeights>{{2, 5}, {5, 2}, {3, 3}}, 5, kChangeBetween),
      (std::vector<int>{1, 0, 0}));
}

}  // namespace
}  // namespace foldwright::testing
