#include "read/text_encoding.h"

#include <gtest/gtest.h>

#include "encodings.h"
#include "mesh/input_error.h"

namespace foldwright::testing {
namespace {

std::span<const std::byte> bytes_of(const std::string& text) {
  return std::as_bytes(std::span(text.data(), text.size()));
}

std::string decoded(const std::string& bytes) {
  std::string storage;
  const auto text = to_utf8(bytes_of(bytes), storage);
  return {reinterpret_cast<const char*>(text.data()), text.size()};
}

TEST(TextEncoding, IsToldByItsMarkOrByWhereNulBytesLie) {
  for (const TextEncoding encoding : kWideEncodings) {
    EXPECT_EQ(text_encoding(bytes_of(encoded(U"\uFEFFv", encoding))), encoding);
    EXPECT_EQ(text_encoding(bytes_of(encoded(U"v ", encoding))), encoding);
  }
  for (const std::string text : {"", "v", "v ", "\xEF\xBB\xBFv 1", "\xFF", "\xC4\xD6"}) {
    EXPECT_EQ(text_encoding(bytes_of(text)), TextEncoding::kUtf8) << text;
  }
  // One letter and padding, as in the header of a binary file.
  EXPECT_EQ(text_encoding(bytes_of(std::string("a\0\0\0\0\0\0\0", 8))), TextEncoding::kUtf8);
}

TEST(ToUtf8, ConvertsCharactersOfEveryLength) {
  const std::string expected = "v \xC3\x9F\xE2\x82\xAC\xF0\x9F\x93\x84\n";
  for (const TextEncoding encoding : kWideEncodings) {
    EXPECT_EQ(decoded(encoded(U"v \u00DF\u20AC\U0001F4C4\n", encoding)), expected);
  }
}

TEST(ToUtf8, LeavesSingleBytesAlone) {
  const std::string latin1 =
      "g Gr\xF6\xDF"
      "e\n";
  std::string storage;
  EXPECT_EQ(to_utf8(bytes_of(latin1), storage).data(), bytes_of(latin1).data());
}

TEST(ToUtf8, ReplacesWhatIsNoCharacter) {
  const std::string replaced = "v \xEF\xBF\xBD";
  EXPECT_EQ(decoded(encoded(U"v ", TextEncoding::kUtf16Le) + "\x3D\xD8"), replaced);  // half a pair
  EXPECT_EQ(decoded(encoded(U"v ", TextEncoding::kUtf16Le) + "\x20"), replaced);      // half a unit
  EXPECT_EQ(decoded(encoded(U"v ", TextEncoding::kUtf32Be) + "\x7F\x01\x01\x01"), replaced);
}

TEST(RefuseNul, NamesTheLine) {
  EXPECT_NO_THROW(refuse_nul(bytes_of("v 1\nv 2\n")));
  try {
    refuse_nul(bytes_of(std::string("v 1\r\nv 2\rv 2\0 0\n", 16)));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "bad-text place=line at=3");
  }
}

}  // namespace
}  // namespace foldwright::testing
