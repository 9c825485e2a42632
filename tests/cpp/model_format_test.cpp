#include "read/model_format.h"

#include <gtest/gtest.h>

#include <string_view>

namespace foldwright::testing {
namespace {

std::span<const std::byte> bytes_of(std::string_view text) {
  return std::as_bytes(std::span(text.data(), text.size()));
}

TEST(FormatOfContents, GoesByFirstWordsAndLines) {
  const std::pair<const char*, std::optional<ModelFormat>> cases[] = {
      {"ply\nformat ascii 1.0\n", ModelFormat::kPly},
      {"# comment\nNCOFF\n8 6 0\n", ModelFormat::kOff},
      {"4nOFF 3\n", ModelFormat::kOff},
      {"solid a name\n  facet normal 0 0 1\n", ModelFormat::kStl},
      {"outer loop\nvertex 0 0 0\n", ModelFormat::kStl},
      {"# comment\nmtllib a.mtl\no a\nv 0 0 0\n", ModelFormat::kObj},
      {"solid rock\n", std::nullopt},
      {"v zero 0 0\n", std::nullopt},
      {"3 1 0\n0 0 0\n", std::nullopt},
      {"offer\n", std::nullopt},
      {"", std::nullopt},
  };
  for (const auto& [text, format] : cases) {
    EXPECT_EQ(format_of_contents(bytes_of(text)), format) << text;
  }
}

TEST(ForeignFormat, IsEmptyForModelsThatAreRead) {
  for (const char* text : {"v 0 0 0\n", "solid\n", "OFF\n", "ply\n", "# PK\n", "", "MM"}) {
    EXPECT_EQ(foreign_format(bytes_of(text)), "") << text;
  }
}

}  // namespace
}  // namespace foldwright::testing
