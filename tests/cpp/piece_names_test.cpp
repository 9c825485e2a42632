#include "pipeline/values/piece_names.h"

#include <gtest/gtest.h>

#include <set>

namespace foldwright::testing {
namespace {

using Names = std::vector<std::string>;

Names names(const std::vector<int>& parts, const std::vector<PartName>& chosen) {
  return piece_names(parts, chosen);
}

TEST(PieceNames, AreLettersInOrder) { EXPECT_EQ(names({2, 0, 1}, {}), (Names{"A", "B", "C"})); }

TEST(PieceNames, AreThoseOfParts) {
  EXPECT_EQ(names({2, 0, 1}, {{0, "Head"}}), (Names{"A", "Head", "C"}));
  EXPECT_EQ(names({0, 0, 1}, {{0, "Leg"}}), (Names{"Leg 1", "Leg 2", "C"}));
}

TEST(PieceNames, AllDiffer) {
  const std::vector<std::vector<PartName>> cases = {
      {{0, "B"}}, {{0, "B"}, {1, "A"}}, {{0, "C"}, {1, "C 1"}}, {{2, "D"}, {0, "E"}}};
  for (const auto& chosen : cases) {
    const Names found = names({0, 1, 2, 0}, chosen);
    EXPECT_EQ(std::set<std::string>(found.begin(), found.end()).size(), found.size());
  }
}

TEST(FaultOfName, SaysWhatIsWrong) {
  for (const char* good : {"A", "Left wing", "12b", "\xe7\xbf\xbc", "<b>\"&"}) {
    EXPECT_EQ(fault_of_name(good), "") << good;
  }
  EXPECT_EQ(fault_of_name("17"), "name-number");
  EXPECT_EQ(fault_of_name("a:b"), "name-colon");
  EXPECT_EQ(fault_of_name("a\nb"), "name-control");
  for (const char* bad : {"", " a", "a ", "a name that is far too long"}) {
    EXPECT_EQ(fault_of_name(bad), "name-length") << bad;
  }
}

}  // namespace
}  // namespace foldwright::testing
