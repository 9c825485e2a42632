#pragma once

#include <string_view>

namespace foldwright {

/// How finely a number is written: "12.50" has 4 significant digits and 2 decimals, "1.5e3" has 2
/// and -2. Zeros that are written count, leading ones do not.
struct WrittenDigits {
  int significant = 0;  ///< 0 for zero
  int decimals = 0;     ///< the last digit stands for 10^-decimals
};

/// The digits of a finite number. \pre parse_number takes the word.
WrittenDigits written_digits(std::string_view word);

/// Estimates from all coordinates of a file how far they were rounded when it was written.
///
/// The result is the largest rounding error to be expected of a coordinate, in model units:
/// - Text: half a unit of the last decimal place. Programs that print a fixed number of decimals
///   show it in the number with the most decimals. Programs that print a fixed number of
///   significant digits ("%g", "%e") reach that number in several powers of ten; there the
///   coordinate of the largest power of ten has the coarsest last place, and decides.
/// - Single precision: half the distance between neighbouring floats at the largest coordinate.
///   This also holds for text and doubles whose values all are floats to within their last place,
///   such as 0.8726779818534851: printing more digits does not make them more precise.
/// - Coordinates that all are whole numbers or binary fractions such as 0.5 and 0.75 were chosen by
///   somebody: rounding to decimals seldom hits one. They are exact unless stored as floats.
/// - Never less than half the distance between neighbouring doubles at the largest coordinate.
class CoordinatePrecision {
 public:
  /// A coordinate that was written as text.
  void add_text(std::string_view word, double value);
  /// A coordinate that was stored as a float.
  void add_single(double value);
  /// A coordinate that was stored as a double or as a whole number.
  void add_double(double value);

  /// Largest rounding error, 0 without coordinates. \pre all coordinates added are finite
  double rounding_error() const;

 private:
  double largest_ = 0;         // magnitude
  bool all_chosen_ = true;     // whole or binary fractions
  bool all_single_ = true;     // to within what is written
  int most_decimals_ = -1000;  // of text; far below any, since no double has such a unit
  int most_significant_ = 0;
  int top_decade_ = -1000;  // decade: power of ten of the leading digit
  int low_decade_ = 0;      // of the numbers with the most significant digits
  int high_decade_ = 0;

  void add(double value, double half_unit);
  void count_digits(const WrittenDigits& digits);
  bool has_fixed_significance() const;
  double text_rounding() const;
};

}  // namespace foldwright
