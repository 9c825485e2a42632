#include "read/off_header.h"

#include <optional>
#include <string>

#include "mesh/input_error.h"

namespace foldwright {
namespace {

/// Takes one prefix from the front of the keyword; false when none stands there.
bool take_prefix(std::string_view& word, bool is_lower_case, OffLayout& layout) {
  if (lower_case(word.substr(0, 2)) == "st") {
    layout.has_texture = true;
    word.remove_prefix(2);
    return true;
  }
  switch (word.empty() ? '\0' : word.front()) {
    case 'n':
      // Only its case tells a dimension from normals. Where all of the keyword is in lower case,
      // it means normals, which are far more common.
      (is_lower_case ? layout.has_normal : layout.has_dimension) = true;
      break;
    case 'N':
      layout.has_normal = true;
      break;
    case 'c':
    case 'C':
      layout.has_colour = true;
      break;
    case '4':
      layout.is_homogeneous = true;
      break;
    default:
      return false;
  }
  word.remove_prefix(1);
  return true;
}

std::optional<OffLayout> parse_keyword(std::string_view word) {
  const bool is_lower_case = lower_case(word) == word;
  OffLayout layout;
  while (take_prefix(word, is_lower_case, layout)) {
  }
  if (lower_case(word) != "off") return std::nullopt;
  return layout;
}

}  // namespace

bool is_off_keyword(std::string_view word) { return parse_keyword(word).has_value(); }

OffLayout read_off_header(TextScanner& scanner) {
  TextScanner after_keyword = scanner;
  const std::string_view first = after_keyword.word();
  if (parse_integer(first)) return {};  // no header
  std::optional<OffLayout> layout = parse_keyword(first);
  if (!layout) {
    throw InputError("bad-header", Place{"line", after_keyword.line()},
                     {{"what", "off-magic"}, {"word", excerpt(first)}});
  }
  scanner = after_keyword;
  if (lower_case(after_keyword.word_in_line()) == "binary") {
    layout->is_binary = true;
    scanner.next_line();
  }
  return *layout;
}

void require_three_dimensions(long long dimension) {
  if (dimension == 3) return;
  throw InputError("bad-header", {{"what", "dimensions"}, {"dimensions", dimension}});
}

}  // namespace foldwright
