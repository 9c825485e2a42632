#include "pipeline/edits/edits.h"

#include <gtest/gtest.h>

#include <map>
#include <numeric>
#include <string>

#include "geometry/random.h"

namespace foldwright::testing {
namespace {

using Numbers = std::vector<int>;

TEST(Edits, ASplitPartKeepsItsNumberAndAddsNewOnes) {
  const std::vector<PartEdit> edits = {{{1}, 3}};
  const EditedNumbers numbers = number_parts(4, edits);
  EXPECT_EQ(numbers.of_edit[0], (Numbers{1, 4, 5}));
  EXPECT_EQ(numbers.of_part, (Numbers{0, -1, 2, 3}));
  EXPECT_EQ(numbers.count, 6);
}

TEST(Edits, AMergedPartKeepsTheLowerNumberAndTheLastPartFillsTheGap) {
  const std::vector<PartEdit> edits = {{{2, 0}, 1}};
  const EditedNumbers numbers = number_parts(5, edits);
  EXPECT_EQ(numbers.of_edit[0], (Numbers{0}));
  EXPECT_EQ(numbers.of_part, (Numbers{-1, 1, -1, 3, 2}));
  EXPECT_EQ(numbers.count, 4);
}

TEST(Edits, NoPartMovesWhenTheLastOneIsMerged) {
  const std::vector<PartEdit> edits = {{{1, 3}, 1}};
  const EditedNumbers numbers = number_parts(4, edits);
  EXPECT_EQ(numbers.of_edit[0], (Numbers{1}));
  EXPECT_EQ(numbers.of_part, (Numbers{0, -1, 2, -1}));
  EXPECT_EQ(numbers.count, 3);
}

TEST(Edits, NumbersSetFreeAreTakenBeforeNewOnes) {
  const std::vector<PartEdit> edits = {{{2}, 3}, {{0, 1}, 1}};
  const EditedNumbers numbers = number_parts(4, edits);
  EXPECT_EQ(numbers.of_edit[0], (Numbers{1, 2, 4}));
  EXPECT_EQ(numbers.of_edit[1], (Numbers{0}));
  EXPECT_EQ(numbers.of_part, (Numbers{-1, -1, -1, 3}));
  EXPECT_EQ(numbers.count, 5);
}

std::map<int, std::string> carried(const std::vector<PartName>& names,
                                   const std::vector<PartEdit>& edits, int count) {
  std::map<int, std::string> by_part;
  for (const auto& [part, name] : carry_names(names, edits, number_parts(count, edits))) {
    EXPECT_TRUE(by_part.emplace(part, name).second) << "part " << part << " has two names";
  }
  return by_part;
}

TEST(Edits, LeaveNamesWithPartsThatStay) {
  const std::vector<PartName> names = {{0, "Head"}, {2, "Leg"}, {4, "Tail"}};
  using ByPart = std::map<int, std::string>;
  EXPECT_EQ(carried(names, {}, 5), (ByPart{{0, "Head"}, {2, "Leg"}, {4, "Tail"}}));
  // Part 4 fills the gap that part 3 leaves.
  EXPECT_EQ(carried(names, {{{1, 3}, 1}}, 5), (ByPart{{0, "Head"}, {2, "Leg"}, {3, "Tail"}}));
  EXPECT_EQ(carried(names, {{{2}, 2}}, 5), (ByPart{{0, "Head"}, {4, "Tail"}}));
  EXPECT_EQ(carried({{7, "Wing"}}, {}, 5), ByPart{});
}

TEST(Edits, HandTheOnlyNameOfMergedPartsOn) {
  const std::vector<PartName> names = {{0, "Head"}, {3, "Leg"}};
  using ByPart = std::map<int, std::string>;
  EXPECT_EQ(carried(names, {{{3, 1}, 1}}, 4), (ByPart{{0, "Head"}, {1, "Leg"}}));
  EXPECT_EQ(carried(names, {{{0, 3}, 1}}, 4), ByPart{});
  EXPECT_EQ(carried(names, {{{3}, 1}}, 4), (ByPart{{0, "Head"}, {3, "Leg"}}));
  EXPECT_EQ(carried(names, {{{1, 3}, 2}}, 4), (ByPart{{0, "Head"}}));
}

TEST(Edits, NumberPartsWithoutGapsAndMoveAsFewAsTheyMust) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const auto draw = [&](int below) { return static_cast<int>(random.uniform() * below); };
    const int count = 1 + draw(12);
    Numbers order(count);
    std::iota(order.begin(), order.end(), 0);
    for (int i = count - 1; i > 0; --i) std::swap(order[i], order[draw(i + 1)]);
    std::vector<PartEdit> edits;
    int lost = 0;
    for (int at = 0; at < count && draw(4) > 0;) {
      const int size = std::min(1 + draw(3), count - at);
      edits.push_back({{order.begin() + at, order.begin() + at + size}, 1 + draw(4)});
      lost += std::max(0, size - edits.back().into);
      at += size;
    }
    const EditedNumbers numbers = number_parts(count, edits);
    std::vector<int> uses(numbers.count, 0);
    int moved = 0;
    for (int part = 0; part < count; ++part) {
      if (numbers.of_part[part] == -1) continue;
      ++uses.at(numbers.of_part[part]);
      moved += numbers.of_part[part] != part;
    }
    for (std::size_t i = 0; i < edits.size(); ++i) {
      EXPECT_EQ(static_cast<int>(numbers.of_edit[i].size()), edits[i].into);
      EXPECT_TRUE(std::ranges::is_sorted(numbers.of_edit[i]));
      for (const int number : numbers.of_edit[i]) ++uses.at(number);
    }
    EXPECT_EQ(uses, Numbers(numbers.count, 1));
    EXPECT_LE(moved, lost);
  }
}

}  // namespace
}  // namespace foldwright::testing
