#include "read/coordinate_precision.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "read/text_scanner.h"

namespace foldwright {
namespace {

/// No double has digits beyond this power of ten, on either side of the point.
constexpr long long kDecadeLimit = 400;

double half_unit(int decimals) {
  // Asked for every coordinate: the usual numbers of decimals take no power.
  static constexpr std::array<double, 10> kUsual = {5e-1, 5e-2, 5e-3, 5e-4, 5e-5,
                                                    5e-6, 5e-7, 5e-8, 5e-9, 5e-10};
  if (decimals >= 0 && decimals < static_cast<int>(kUsual.size())) return kUsual[decimals];
  return 0.5 * std::pow(10.0, -decimals);
}

/// Half the distance between neighbouring numbers around `value` whose mantissa has `bits` bits.
double half_spacing(double value, int bits) {
  return value == 0 ? 0 : std::ldexp(0.5, std::ilogb(value) - (bits - 1));
}

/// Whether a float lies within `tolerance`.
bool is_single(double value, double tolerance) {
  if (std::abs(value) > std::numeric_limits<float>::max()) return false;
  return std::abs(value - static_cast<double>(static_cast<float>(value))) <= tolerance;
}

/// Whether a person or a grid is likely to have chosen the number: multiples of 1/64, which is as
/// fine as binary fractions of an inch go.
bool is_chosen(double value) { return 64 * value == std::floor(64 * value); }

}  // namespace

WrittenDigits written_digits(std::string_view word) {
  WrittenDigits digits;
  bool seen_point = false;
  std::size_t i = 0;
  for (; i < word.size() && word[i] != 'e' && word[i] != 'E'; ++i) {
    seen_point = seen_point || word[i] == '.' || word[i] == ',';
    if (word[i] < '0' || word[i] > '9') continue;
    if (seen_point) ++digits.decimals;
    if (word[i] != '0' || digits.significant > 0) ++digits.significant;
  }
  if (i < word.size()) {
    const long long exponent = parse_integer(word.substr(i + 1)).value_or(0);
    digits.decimals -= static_cast<int>(std::clamp(exponent, -kDecadeLimit, kDecadeLimit));
  }
  return digits;
}

void CoordinatePrecision::add_text(std::string_view word, double value) {
  // A zero is exact, however it is written.
  if (value == 0) return;
  const WrittenDigits digits = written_digits(word);
  count_digits(digits);
  all_chosen_ = all_chosen_ && is_chosen(value);
  add(value, all_single_ ? half_unit(digits.decimals) : 0);
}

void CoordinatePrecision::add_single(double value) {
  all_chosen_ = false;
  add(value, 0);
}

void CoordinatePrecision::add_double(double value) {
  all_chosen_ = all_chosen_ && is_chosen(value);
  add(value, 0);
}

void CoordinatePrecision::add(double value, double half_unit) {
  largest_ = std::max(largest_, std::abs(value));
  all_single_ = all_single_ && is_single(value, half_unit);
}

void CoordinatePrecision::count_digits(const WrittenDigits& digits) {
  const int decade = digits.significant - digits.decimals - 1;
  most_decimals_ = std::max(most_decimals_, digits.decimals);
  top_decade_ = std::max(top_decade_, decade);
  if (digits.significant > most_significant_) {
    most_significant_ = digits.significant;
    low_decade_ = high_decade_ = decade;
  } else if (digits.significant == most_significant_) {
    low_decade_ = std::min(low_decade_, decade);
    high_decade_ = std::max(high_decade_, decade);
  }
}

bool CoordinatePrecision::has_fixed_significance() const {
  // With a fixed number of decimals only the largest numbers have the most digits. Short numbers
  // without their last zeros, such as 1.25 and 0.125, look alike by chance; "%g" writes 6 digits.
  constexpr int kFewestDigits = 6;
  return most_significant_ >= kFewestDigits && low_decade_ < high_decade_;
}

double CoordinatePrecision::text_rounding() const {
  if (all_chosen_ || most_significant_ == 0) return 0;
  return half_unit(has_fixed_significance() ? most_significant_ - 1 - top_decade_ : most_decimals_);
}

double CoordinatePrecision::rounding_error() const {
  double error = std::max(text_rounding(), half_spacing(largest_, 53));
  if (all_single_ && !all_chosen_) {
    error = std::max(error, half_spacing(largest_, 24));
  }
  return error;
}

}  // namespace foldwright
