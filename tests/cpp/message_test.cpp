#include "mesh/message.h"

#include <gtest/gtest.h>

#include <set>

#include "mesh/input_error.h"

namespace foldwright::testing {
namespace {

TEST(MessageCodes, AreStableWordsAndAllDiffer) {
  std::set<std::string_view> seen;
  for (const std::string_view code : kMessageCodes) {
    EXPECT_TRUE(seen.insert(code).second) << code;
    EXPECT_EQ(code.find_first_not_of("abcdefghijklmnopqrstuvwxyz-"), std::string_view::npos)
        << code;
  }
  EXPECT_TRUE(is_message_code("bad-index"));
  EXPECT_FALSE(is_message_code("bad-indices"));
}

TEST(Describe, WritesEveryKindOfValueInOrder) {
  const Message message("bad-pin", {{"what", "overlap"},
                                    {"sheet", 1000000},
                                    {"share", 0.25},
                                    {"pieces", std::vector<std::string>{"A", "Wing"}},
                                    {"parts", std::vector<int>{3, 1}}});
  EXPECT_EQ(describe(message),
            "bad-pin what=overlap sheet=1000000 share=0.25 pieces=A,Wing parts=3,1");
  EXPECT_EQ(describe(Message("empty-file")), "empty-file");
}

TEST(InputError, NamesThePlaceBeforeTheRest) {
  const InputError error("truncated", Place{"line", 7}, {{"what", "face"}});
  EXPECT_EQ(error.code(), "truncated");
  EXPECT_EQ(error.parameters(), (Parameters{{"place", "line"}, {"at", 7}, {"what", "face"}}));
  EXPECT_STREQ(error.what(), "truncated place=line at=7 what=face");
  EXPECT_TRUE(error.faces().empty());
}

}  // namespace
}  // namespace foldwright::testing
