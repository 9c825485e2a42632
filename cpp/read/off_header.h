#pragma once

#include <string_view>

#include "read/text_scanner.h"

namespace foldwright {

/// What the first line of an OFF file says about the numbers of each vertex: "STCN4nOFF BINARY".
struct OffLayout {
  bool is_homogeneous = false;  ///< "4": a fourth coordinate, by which the others are divided
  bool has_dimension = false;   ///< "n": the dimension comes before the counts
  bool has_normal = false;      ///< "N"
  bool has_colour = false;      ///< "C"
  bool has_texture = false;     ///< "ST"
  bool is_binary = false;
};

/// Whether a word is the keyword of an OFF file, with its prefixes in any order and case.
bool is_off_keyword(std::string_view word);

/// Reads the keyword, if there is one, and what stands beside it; numbers follow, in binary from
/// the next line on. \throw InputError ("bad-header") naming the line
OffLayout read_off_header(TextScanner& scanner);

/// Refuses all dimensions but 3. \throw InputError ("bad-header")
void require_three_dimensions(long long dimension);

}  // namespace foldwright
