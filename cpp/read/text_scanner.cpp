#include "read/text_scanner.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace foldwright {
namespace {

bool is_line_break(char c) { return c == '\n' || c == '\r'; }

// Other control characters belong to words, so that none splits a number. DOS ended texts with
// the control character 26.
bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f' || c == '\x1A'; }

bool is_decimal_mark(char c) { return c == '.' || c == ','; }

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Digits and decimal exponent of a number: value = digits * 10^exponent.
struct Decimal {
  bool negative = false;
  std::string digits;  // without leading zeros
  long long exponent = 0;
};

/// Exponents saturate here: beyond any double, yet far from overflow when digits shift them.
constexpr long long kExponentLimit = 1'000'000'000;

/// Reads "e-12" at the end of a number into `exponent`; false when it is malformed.
bool parse_exponent(std::string_view word, long long& exponent) {
  if (word.empty()) return true;
  if (word.front() != 'e' && word.front() != 'E') return false;
  const std::optional<long long> value = parse_integer(word.substr(1));
  if (!value) return false;
  exponent += std::clamp(*value, -kExponentLimit, kExponentLimit);
  return true;
}

std::optional<Decimal> parse_decimal(std::string_view word) {
  // No double, nor the middle between two, has more than 768 significant digits: one more digit
  // that tells whether something follows makes the rounding right.
  constexpr std::size_t kMaxDigits = 768;
  Decimal decimal;
  std::size_t i = 0;
  if (i < word.size() && (word[i] == '-' || word[i] == '+')) decimal.negative = word[i++] == '-';
  bool seen_digit = false;
  bool seen_point = false;
  bool rest_is_zero = true;
  for (; i < word.size(); ++i) {
    if (is_decimal_mark(word[i]) && !seen_point) {
      seen_point = true;
      continue;
    }
    if (!is_digit(word[i])) break;
    seen_digit = true;
    if (seen_point) --decimal.exponent;
    if (decimal.digits.empty() && word[i] == '0') continue;
    if (decimal.digits.size() < kMaxDigits) {
      decimal.digits += word[i];
    } else {
      ++decimal.exponent;
      rest_is_zero = rest_is_zero && word[i] == '0';
    }
  }
  if (!rest_is_zero) {
    decimal.digits += '1';
    --decimal.exponent;
  }
  if (!seen_digit || !parse_exponent(word.substr(i), decimal.exponent)) return std::nullopt;
  return decimal;
}

double value_of(const Decimal& decimal) {
  // strtod expects the locale's decimal point; a number without any has no such trouble.
  const std::string text = '0' + decimal.digits + 'e' + std::to_string(decimal.exponent);
  const double magnitude = std::strtod(text.c_str(), nullptr);
  return decimal.negative ? -magnitude : magnitude;
}

/// A number of few digits, as nearly every number in a model file is; empty for all others.
std::optional<double> parse_short(std::string_view word) {
  // Both factors are exact up to these bounds, so that one correctly rounded operation gives the
  // nearest double (Clinger 1990).
  constexpr std::size_t kExactDigits = 15;
  constexpr int kExactPower = 22;
  static constexpr double kPowers[kExactPower + 1] = {
      1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
      1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
  const bool is_negative = word.starts_with('-');
  if (is_negative || word.starts_with('+')) word.remove_prefix(1);
  long long mantissa = 0;
  long long exponent = 0;
  std::size_t i = 0;
  std::size_t digits = 0;
  bool seen_point = false;
  for (; i < word.size() && (is_digit(word[i]) || (is_decimal_mark(word[i]) && !seen_point)); ++i) {
    if (is_decimal_mark(word[i])) {
      seen_point = true;
      continue;
    }
    if (++digits > kExactDigits) return std::nullopt;
    mantissa = 10 * mantissa + (word[i] - '0');
    exponent -= seen_point;
  }
  if (digits == 0 || !parse_exponent(word.substr(i), exponent)) return std::nullopt;
  if (std::abs(exponent) > kExactPower) return std::nullopt;
  const double value = static_cast<double>(mantissa);
  const double magnitude = exponent < 0 ? value / kPowers[-exponent] : value * kPowers[exponent];
  return is_negative ? -magnitude : magnitude;
}

/// "nan", "-inf", "1.#QNAN" and the like.
std::optional<double> parse_non_finite(std::string_view word) {
  if (!word.empty() && (word.front() == '-' || word.front() == '+')) word.remove_prefix(1);
  const std::string lower = lower_case(word);
  if (lower == "inf" || lower == "infinity" || lower.starts_with("1.#inf")) {
    return std::numeric_limits<double>::infinity();
  }
  if (lower == "nan" || lower.starts_with("nan(") || lower.starts_with("1.#")) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  return std::nullopt;
}

[[noreturn]] void fail_at_end(int line) {
  throw InputError("truncated", Place{"line", line}, {{"what", "number"}});
}

}  // namespace

TextScanner::TextScanner(std::span<const std::byte> bytes, LineContinuation continuation)
    : text_(reinterpret_cast<const char*>(bytes.data()), bytes.size()),
      continuation_(continuation) {
  if (text_.starts_with("\xEF\xBB\xBF")) position_ = 3;
}

void TextScanner::skip_line_break() {
  if (text_.substr(position_).starts_with("\r\n")) ++position_;
  ++position_;
  if (!at_end()) ++line_;  // what is missing at the end is missing in the last line
}

bool TextScanner::at_continuation() const {
  return continuation_ == LineContinuation::kBackslash && text_[position_] == '\\' &&
         position_ + 1 < text_.size() && is_line_break(text_[position_ + 1]);
}

std::string_view TextScanner::word_in_line() {
  while (!at_end() && (is_blank(text_[position_]) || at_continuation())) {
    if (text_[position_++] == '\\') skip_line_break();
  }
  if (!at_end() && text_[position_] == '#') {
    while (!at_end() && !is_line_break(text_[position_])) ++position_;
  }
  const std::size_t begin = position_;
  while (!at_end() && !is_blank(text_[position_]) && !is_line_break(text_[position_]) &&
         !at_continuation()) {
    ++position_;
  }
  return text_.substr(begin, position_ - begin);
}

std::string_view TextScanner::word() {
  std::string_view found = word_in_line();
  while (found.empty() && next_line()) found = word_in_line();
  return found;
}

std::string_view TextScanner::rest_of_line() {
  while (!at_end() && is_blank(text_[position_])) ++position_;
  const std::size_t begin = position_;
  std::size_t end = begin;
  for (; !at_end() && !is_line_break(text_[position_]) && !at_continuation(); ++position_) {
    if (!is_blank(text_[position_])) end = position_ + 1;
  }
  return text_.substr(begin, end - begin);
}

bool TextScanner::next_line() {
  while (!at_end() && !is_line_break(text_[position_])) {
    if (at_continuation()) {
      ++position_;
      skip_line_break();
    } else {
      ++position_;
    }
  }
  if (at_end()) return false;
  skip_line_break();
  return !at_end();
}

std::string_view TextScanner::number_word() {
  const std::string_view found = word();
  if (found.empty()) fail_at_end(line_);
  return found;
}

double TextScanner::number() {
  const std::string_view found = number_word();
  return number_of(found, line_);
}

long long TextScanner::integer() {
  const std::string_view found = number_word();
  return integer_of(found, line_);
}

std::optional<double> parse_number(std::string_view word) {
  if (const std::optional<double> value = parse_short(word)) return value;
  const std::optional<Decimal> decimal = parse_decimal(word);
  return decimal ? value_of(*decimal) : parse_non_finite(word);
}

std::optional<long long> parse_integer(std::string_view word) {
  constexpr long long kLimit = 1'000'000'000'000'000;
  const bool negative = word.starts_with('-');
  if (negative || word.starts_with('+')) word.remove_prefix(1);
  if (word.empty()) return std::nullopt;
  long long value = 0;
  for (const char c : word) {
    if (!is_digit(c)) return std::nullopt;
    value = std::min(10 * value + (c - '0'), kLimit);
  }
  return negative ? -value : value;
}

double number_of(std::string_view word, int line) {
  if (const std::optional<double> value = parse_number(word)) return *value;
  throw no_number(word, line);
}

long long integer_of(std::string_view word, int line) {
  if (const std::optional<long long> value = parse_integer(word)) return *value;
  throw no_whole_number(word, line);
}

InputError no_number(std::string_view word, int line) {
  const bool has_comma = word.find(',') != std::string_view::npos;
  return {"bad-number",
          Place{"line", line},
          {{"what", has_comma ? "comma" : "number"}, {"word", excerpt(word)}}};
}

InputError no_whole_number(std::string_view word, int line) {
  return {"bad-number", Place{"line", line}, {{"what", "whole"}, {"word", excerpt(word)}}};
}

std::string excerpt(std::string_view word) {
  constexpr std::size_t kLongest = 24;  // enough to recognise the place
  std::string text;
  for (const char c : word.substr(0, kLongest)) text += c > ' ' && c <= '~' ? c : '?';
  return word.size() > kLongest ? text + "..." : text;
}

std::string lower_case(std::string_view word) {
  std::string lower(word);
  for (char& c : lower) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return lower;
}

}  // namespace foldwright
