#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "mesh/input_error.h"

namespace foldwright {

enum class LineContinuation { kNone, kBackslash };

/// Walks through a text file line by line and word by word, and knows the number of the line.
///
/// Lines end with LF, CR LF or CR; words are separated by blanks and tabs; a word
/// that begins with '#' starts a comment that lasts to the end of the line. A byte order mark is
/// skipped. With `kBackslash` a line that ends with a backslash goes on in the next one. Refers to
/// the bytes, which must outlive it; never reads beyond them.
class TextScanner {
 public:
  explicit TextScanner(std::span<const std::byte> bytes,
                       LineContinuation continuation = LineContinuation::kNone);

  /// Next word of the current line; empty at its end.
  std::string_view word_in_line();
  /// Next word, on whatever line; empty at the end of the file.
  std::string_view word();
  /// What is left of the current line, comments included, without blanks at both ends: a name.
  /// A continuation ends it.
  std::string_view rest_of_line();
  /// Goes to the beginning of the next line; false when there is none.
  bool next_line();

  bool at_end() const { return position_ == text_.size(); }
  /// Number of the current line, from 1.
  int line() const { return line_; }
  /// Offset of the next byte to be read, for files that go on in binary.
  std::size_t position() const { return position_; }

  /// Next word, on whatever line, where a number is expected.
  /// \throw InputError ("truncated") naming the line
  std::string_view number_word();
  /// Next word, on whatever line, as a number. NaN and infinities pass.
  /// \throw InputError ("bad-number", "truncated") naming the line
  double number();
  /// Next word, on whatever line, as a whole number.
  /// \throw InputError ("bad-number", "truncated") naming the line
  long long integer();

 private:
  std::string_view text_;
  std::size_t position_ = 0;
  int line_ = 1;
  LineContinuation continuation_;

  void skip_line_break();
  bool at_continuation() const;
};

/// A decimal number, rounded to the nearest double, whatever the locale, with a point or, as
/// programs in many languages write it, a comma; also "nan" and "inf" in the spellings that C
/// libraries print. Empty when the word is anything else.
std::optional<double> parse_number(std::string_view word);

/// A whole number, possibly signed; saturates far outside the range of any index. Empty when the
/// word is anything else.
std::optional<long long> parse_integer(std::string_view word);

/// The word as a number. \throw InputError ("bad-number") naming the line
double number_of(std::string_view word, int line);

/// The word as a whole number. \throw InputError ("bad-number") naming the line
long long integer_of(std::string_view word, int line);

/// What a file is refused for whose word in that line is no number, or no whole number.
InputError no_number(std::string_view word, int line);
InputError no_whole_number(std::string_view word, int line);

/// The word, shortened and without unprintable characters, fit for a message.
std::string excerpt(std::string_view word);

/// ASCII lower case, whatever the locale.
std::string lower_case(std::string_view word);

}  // namespace foldwright
