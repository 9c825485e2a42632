#include "read/text_scanner.h"

#include <gtest/gtest.h>

#include <clocale>
#include <cmath>
#include <string>

#include "geometry/random.h"
#include "mesh/input_error.h"

namespace foldwright {
namespace {

std::span<const std::byte> bytes_of(std::string_view text) {
  return std::as_bytes(std::span(text.data(), text.size()));
}

TEST(TextScanner, CountsLinesWhateverEndsThem) {
  TextScanner scanner(bytes_of("a\nb\r\nc\rd"));
  for (const char* word : {"a", "b", "c", "d"}) EXPECT_EQ(scanner.word(), word);
  EXPECT_EQ(scanner.line(), 4);
  EXPECT_EQ(scanner.word(), "");
  EXPECT_TRUE(scanner.at_end());
}

TEST(TextScanner, StopsAtTheEndOfTheLine) {
  TextScanner scanner(bytes_of("a \t b # comment\nc"));
  EXPECT_EQ(scanner.word_in_line(), "a");
  EXPECT_EQ(scanner.word_in_line(), "b");
  EXPECT_EQ(scanner.word_in_line(), "");
  EXPECT_TRUE(scanner.next_line());
  EXPECT_EQ(scanner.word_in_line(), "c");
}

TEST(TextScanner, GoesOnAfterABackslashOnlyWhenAsked) {
  const std::string_view text = "f 1\\\r\n2 \\\n 3";
  TextScanner joined(bytes_of(text), LineContinuation::kBackslash);
  for (const char* word : {"f", "1", "2", "3"}) EXPECT_EQ(joined.word_in_line(), word);
  EXPECT_EQ(joined.line(), 3);
  TextScanner separate(bytes_of(text));
  separate.word_in_line();
  EXPECT_EQ(separate.word_in_line(), "1\\");
}

TEST(TextScanner, NamesTheLineOfABadNumber) {
  TextScanner scanner(bytes_of("1\n2\nx"));
  scanner.number();
  scanner.number();
  try {
    scanner.number();
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "bad-number place=line at=3 what=number word=x");
  }
}

TEST(ParseNumber, RoundsLikeTheLanguage) {
  const std::pair<const char*, double> cases[] = {
      {"0", 0.0},
      {"-0.5", -0.5},
      {"+1.25e2", 125.0},
      {".5", 0.5},
      {"5.", 5.0},
      {"1E-3", 1e-3},
      {"8e-001", 0.8},
      {"0.1", 0.1},
      {"123456789012345678901234567890", 123456789012345678901234567890.0},
      {"2.2250738585072011e-308", 2.2250738585072011e-308},
      {"1e-400", 0.0},
      {"1.7976931348623157e308", 1.7976931348623157e308},
      {"9007199254740993", 9007199254740993.0},  // halfway between two doubles
      {"9007199254740993.00000000000000000000000000000000001", 9007199254740994.0},
  };
  for (const auto& [text, value] : cases) EXPECT_EQ(parse_number(text), value) << text;
}

TEST(ParseNumber, ReadsBackWhatIsPrinted) {
  Random random(7);
  for (int i = 0; i < 2000; ++i) {
    const double value = std::ldexp(random.uniform() - 0.5, random.below(600) - 300);
    char text[64];
    for (const char* format : {"%.17g", "%.25e", "%.6f"}) {
      std::snprintf(text, sizeof text, format, value);
      EXPECT_EQ(parse_number(text), std::strtod(text, nullptr)) << text;
    }
  }
}

TEST(ParseNumber, DoesNotDependOnTheLocale) {
  const char* comma_locale = std::setlocale(LC_NUMERIC, "de_DE.UTF-8");
  EXPECT_EQ(parse_number("0.1234567890123456789"), 0.1234567890123456789);
  EXPECT_EQ(parse_number("0,5"), 0.5);
  if (comma_locale != nullptr) std::setlocale(LC_NUMERIC, "C");
}

TEST(ParseNumber, KnowsWhatIsNotFinite) {
  for (const char* text : {"nan", "-NaN", "nan(ind)", "1.#QNAN", "-1.#IND"}) {
    EXPECT_TRUE(std::isnan(parse_number(text).value())) << text;
  }
  for (const char* text : {"inf", "-Infinity", "1.#INF", "1e999", "-1e99999999999999999999"}) {
    EXPECT_TRUE(std::isinf(parse_number(text).value())) << text;
  }
}

TEST(ParseNumber, RefusesEverythingElse) {
  for (const char* text :
       {"", "-", ".", "e5", "1e", "1e+", "1.2.3", "0x10", "1f", "--1", "1e5.0"}) {
    EXPECT_EQ(parse_number(text), std::nullopt) << text;
  }
}

TEST(ParseInteger, SaturatesInsteadOfOverflowing) {
  EXPECT_EQ(parse_integer("-42"), -42);
  EXPECT_EQ(parse_integer("+7"), 7);
  EXPECT_GT(parse_integer("99999999999999999999999999"), 1'000'000'000'000);
  for (const char* text : {"", "-", "1.0", "1e3", "a"}) {
    EXPECT_EQ(parse_integer(text), std::nullopt) << text;
  }
}

TEST(Quoted, IsShortAndPrintable) {
  EXPECT_EQ(excerpt("abc"), "abc");
  EXPECT_EQ(excerpt("a\nb\xFF"), "a?b?");
  EXPECT_LT(foldwright::excerpt(std::string(1000, 'x')).size(), 40u);
}

}  // namespace
}  // namespace foldwright
