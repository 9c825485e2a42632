#include "read/stl_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "mesh/input_error.h"
#include "read/soup_builder.h"
#include "read/text_encoding.h"
#include "read/text_scanner.h"

namespace foldwright {
namespace {

enum class Keyword {
  kSolid,
  kFacet,
  kLoop,
  kVertex,
  kEndLoop,
  kEndFacet,
  kEndSolid,
  kColour,
  kNone
};

/// Whether a word in any case is `lower`; nothing is allocated, since every word is asked.
bool is_word(std::string_view word, std::string_view lower) {
  return std::equal(word.begin(), word.end(), lower.begin(), lower.end(), [](char c, char l) {
    return c == l || (c >= 'A' && c <= 'Z' && c - 'A' + 'a' == l);
  });
}

Keyword keyword_of(std::string_view word) {
  static constexpr std::array<std::pair<std::string_view, Keyword>, 10> kWords = {{
      {"vertex", Keyword::kVertex},
      {"facet", Keyword::kFacet},
      {"outer", Keyword::kLoop},
      {"loop", Keyword::kLoop},
      {"endloop", Keyword::kEndLoop},
      {"endfacet", Keyword::kEndFacet},
      {"solid", Keyword::kSolid},
      {"endsolid", Keyword::kEndSolid},
      {"color", Keyword::kColour},
      {"colour", Keyword::kColour},
  }};
  for (const auto& [name, keyword] : kWords) {
    if (is_word(word, name)) return keyword;
  }
  return Keyword::kNone;
}

Keyword end_of(Keyword begin) {
  switch (begin) {
    case Keyword::kLoop:
      return Keyword::kEndLoop;
    case Keyword::kFacet:
      return Keyword::kEndFacet;
    case Keyword::kSolid:
      return Keyword::kEndSolid;
    default:
      return Keyword::kNone;
  }
}

/// Skips a solid's name, which may be anything, up to the end of the line or to the first facet.
void skip_name(TextScanner& scanner) {
  for (TextScanner ahead = scanner; !ahead.word_in_line().empty(); scanner = ahead) {
    TextScanner inside = scanner;
    if (keyword_of(inside.word_in_line()) != Keyword::kFacet) continue;
    if (is_word(inside.word_in_line(), "normal")) return;
  }
  scanner.next_line();
}

/// Skips a normal, which is often zero, wrong, NaN or missing, and never needed.
void skip_normal(TextScanner& scanner) {
  TextScanner ahead = scanner;
  for (std::string_view word = ahead.word_in_line(); !word.empty(); word = ahead.word_in_line()) {
    if (keyword_of(word) != Keyword::kNone) return;
    scanner = ahead;
  }
  while (parse_number(ahead.word())) scanner = ahead;
}

class StlText {
 public:
  StlText(std::span<const std::byte> bytes, SoupBuilder& builder)
      : scanner_(bytes), builder_(builder) {}

  void read() {
    for (std::string_view word = scanner_.word(); !word.empty(); word = scanner_.word()) {
      take(is_word(word, "end") ? end_of(keyword_of(scanner_.word())) : keyword_of(word), word);
    }
    if (in_face_) fail_unexpected("");
    if (in_solid_) {
      builder_.note({"missing-endsolid", 1});
    }
  }

 private:
  TextScanner scanner_;
  SoupBuilder& builder_;
  Place place_{"line", 1};  // of the face
  bool in_solid_ = false;
  bool in_face_ = false;
  bool is_bare_ = false;        // the face has no words around its vertices
  int corners_ = 0;             // of the face
  std::optional<Vec3> colour_;  // of the faces that follow

  void take(Keyword keyword, std::string_view word) {
    switch (keyword) {
      case Keyword::kVertex:
        return add_vertex();
      case Keyword::kFacet:
        end_face();
        begin_face();
        return skip_normal(scanner_);
      case Keyword::kLoop:
        if (corners_ > 0) end_face();
        return begin_face();
      case Keyword::kEndLoop:
      case Keyword::kEndFacet:
        return end_face();
      case Keyword::kSolid:
      case Keyword::kEndSolid:
        end_face();
        in_solid_ = keyword == Keyword::kSolid;
        return skip_name(scanner_);
      case Keyword::kColour:
        return take_colour();
      case Keyword::kNone:
        fail_unexpected(word);
    }
  }

  /// Of the faces that follow.
  void take_colour() {
    Vec3 colour;
    for (double& part : colour) {
      part = parse_number(scanner_.word_in_line()).value_or(std::nan(""));
    }
    if (colour.allFinite()) colour_ = colour;
    scanner_.next_line();
  }

  void begin_face() {
    if (in_face_) return;
    in_face_ = true;
    is_bare_ = false;
    place_.number = scanner_.line();
  }

  void end_face() {
    if (!in_face_) return;
    builder_.end_face(place_);
    if (colour_) builder_.looks().colour_face(builder_.face_count() - 1, *colour_);
    in_face_ = false;
    corners_ = 0;
  }

  void add_vertex() {
    if (!in_face_) {
      begin_face();
      is_bare_ = true;
    }
    const Place place{"line", scanner_.line()};
    Vec3 position;
    for (double& coordinate : position) {
      const std::string_view word = scanner_.number_word();
      coordinate = builder_.text_coordinate(word, scanner_.line());
    }
    builder_.add_vertex(position, place);
    builder_.add_corner(builder_.vertex_count() - 1);
    if (++corners_ == 3 && is_bare_) end_face();
  }

  [[noreturn]] void fail_unexpected(std::string_view word) const {
    const Place place{"line", scanner_.line()};
    const char* expected = in_face_ ? "endloop" : "facet";
    if (scanner_.at_end()) {  // the last word may be half of the expected one
      throw InputError("truncated", place, {{"what", "keyword"}, {"expected", expected}});
    }
    throw InputError("bad-syntax", place, {{"word", excerpt(word)}, {"expected", expected}});
  }
};

bool has_facet(TextScanner scanner) {
  for (std::string_view word = scanner.word(); !word.empty(); word = scanner.word()) {
    const Keyword keyword = keyword_of(word);
    if (keyword == Keyword::kFacet || keyword == Keyword::kVertex) return true;
  }
  return false;
}

}  // namespace

bool is_stl_text(std::span<const std::byte> bytes) {
  TextScanner scanner(bytes);
  const Keyword first = keyword_of(scanner.word());
  if (first == Keyword::kFacet || first == Keyword::kLoop) return has_facet(scanner);
  return first == Keyword::kSolid && has_facet(scanner);
}

PolygonSoup read_stl_text(std::span<const std::byte> bytes) {
  refuse_nul(bytes);
  return build_soup(0, [&](SoupBuilder& builder) { StlText(bytes, builder).read(); });
}

}  // namespace foldwright
