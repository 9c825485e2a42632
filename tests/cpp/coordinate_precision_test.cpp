#include "read/coordinate_precision.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <initializer_list>
#include <string>

#include "read/text_scanner.h"

namespace foldwright::testing {
namespace {

double error_of(std::initializer_list<const char*> words) {
  CoordinatePrecision precision;
  for (const char* word : words) precision.add_text(word, parse_number(word).value());
  return precision.rounding_error();
}

/// Rounding error of many numbers of several powers of ten that are printed with `format`.
double error_of_printed(const char* format) {
  CoordinatePrecision precision;
  for (int i = 1; i < 200; ++i) {
    char word[64];
    std::snprintf(word, sizeof word, format, std::sin(i) * std::pow(10.0, i % 4));
    precision.add_text(word, parse_number(word).value());
  }
  return precision.rounding_error();
}

TEST(WrittenDigits, CountsZerosThatAreWritten) {
  const auto expect = [](const char* word, int significant, int decimals) {
    const WrittenDigits digits = written_digits(word);
    EXPECT_EQ(digits.significant, significant) << word;
    EXPECT_EQ(digits.decimals, decimals) << word;
  };
  expect("12.50", 4, 2);
  expect("-0.0125", 3, 4);
  expect("1.5e3", 2, -2);
  expect("+.5E-2", 1, 3);
  expect("300", 3, 0);
  expect("7.", 1, 0);
  expect("0.000", 0, 3);
  expect("1e99999999999999999999", 1, -400);
}

TEST(CoordinatePrecision, IsHalfAUnitOfTheLastDecimal) {
  EXPECT_DOUBLE_EQ(error_of({"0", "1.41202", "0.53934", "-0.5"}), 5e-6);
  EXPECT_DOUBLE_EQ(error_of({"1.4", "0.5", "0.9"}), 0.05);
  EXPECT_DOUBLE_EQ(error_of({"100", "0.35", "0"}), 0.005);
  for (int decimals = 1; decimals <= 9; ++decimals) {
    const std::string format = "%." + std::to_string(decimals) + "f";
    EXPECT_NEAR(error_of_printed(format.c_str()) / (0.5 * std::pow(10.0, -decimals)), 1, 1e-12);
  }
}

TEST(CoordinatePrecision, TakesExponentsIntoAccount) {
  EXPECT_DOUBLE_EQ(error_of({"1.41202e-6", "0.53934e-6"}), 5e-12);
  EXPECT_DOUBLE_EQ(error_of({"1.25e4", "0.6"}), 0.05);
}

TEST(CoordinatePrecision, IsThatOfTheLargestNumberForSignificantDigits) {
  // The numbers reach 999.9: six digits leave three decimals.
  EXPECT_DOUBLE_EQ(error_of_printed("%g"), 5e-4);
  EXPECT_DOUBLE_EQ(error_of_printed("%.6e"), 5e-5);
  EXPECT_DOUBLE_EQ(error_of({"4.64978e+06", "512.312", "0"}), 5);
}

TEST(CoordinatePrecision, KnowsSinglePrecisionThatIsPrintedInFull) {
  CoordinatePrecision precision;
  for (int i = 1; i < 100; ++i) {
    const double value = static_cast<double>(static_cast<float>(100 * std::sin(i)));
    char word[64];
    std::snprintf(word, sizeof word, "%.17g", value);
    precision.add_text(word, value);
  }
  EXPECT_EQ(precision.rounding_error(), std::ldexp(1.0, 6 - 24));
}

TEST(CoordinatePrecision, TakesWholeNumbersAndBinaryFractionsAsExact) {
  EXPECT_EQ(error_of({"0.5", "-10.25", "3.125", "1"}), std::ldexp(1.0, 3 - 53));
  EXPECT_DOUBLE_EQ(error_of({"0.5", "-10.25", "3.125", "1.1"}), 5e-4);
  EXPECT_EQ(error_of({"0", "1", "30", "-20"}), std::ldexp(1.0, 4 - 53));
  EXPECT_EQ(error_of({"1.000000e+00", "30.0"}), std::ldexp(1.0, 4 - 53));
}

TEST(CoordinatePrecision, IsNeverFinerThanDoubles) {
  EXPECT_EQ(error_of({"0.12345678901234567890123", "700.1234567890123456789012"}),
            std::ldexp(1.0, 9 - 53));
}

TEST(CoordinatePrecision, KnowsHowNumbersAreStored) {
  CoordinatePrecision singles;
  singles.add_single(100);
  singles.add_single(0.5);
  EXPECT_EQ(singles.rounding_error(), std::ldexp(1.0, 6 - 24));
  CoordinatePrecision doubles;
  doubles.add_double(100.1);
  EXPECT_EQ(doubles.rounding_error(), std::ldexp(1.0, 6 - 53));
  doubles.add_single(100);
  EXPECT_EQ(CoordinatePrecision().rounding_error(), 0);
}

}  // namespace
}  // namespace foldwright::testing
