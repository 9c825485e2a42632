#include <limits>
#include <optional>
#include <string_view>
#include <vector>

#include "mesh/input_error.h"
#include "read/formats.h"
#include "read/off_binary.h"
#include "read/off_header.h"
#include "read/off_looks.h"
#include "read/soup_builder.h"
#include "read/text_encoding.h"
#include "read/text_scanner.h"

namespace foldwright {
namespace {

Place here(const TextScanner& scanner) { return {"line", scanner.line()}; }

/// The counts are never trusted with an allocation, only with this message.
[[noreturn]] void fail_at_end(const TextScanner& scanner, const char* what, long long done,
                              long long announced) {
  throw InputError("truncated", here(scanner),
                   {{"what", what}, {"done", done}, {"announced", announced}});
}

struct Counts {
  long long vertices;
  long long faces;
};

Counts read_counts(TextScanner& scanner, const OffLayout& layout) {
  if (layout.has_dimension) require_three_dimensions(scanner.integer());
  if (TextScanner(scanner).word().empty()) {
    throw InputError("truncated", here(scanner), {{"what", "header-only"}});
  }
  const long long vertices = scanner.integer();
  const Counts counts{vertices, scanner.integer()};
  if (counts.vertices < 0 || counts.faces < 0) {
    throw InputError("bad-header", here(scanner), {{"what", "counts"}});
  }
  return counts;
}

/// What comes between the counts, the vertices and the faces.
struct Gaps {
  bool is_line_each = false;  // every vertex and face has a line of its own
  bool end_with_line = true;  // all that follows in the line, or else so many words:
  int after_counts = 0;       // the number of edges
  int after_vertex = 0;       // normal, colour, texture coordinates
  int after_face = 0;         // colour
};

/// The numbers of a gap, up to the first word that is none.
std::vector<double> read_gap(TextScanner& scanner, const Gaps& gaps, int words) {
  std::vector<double> numbers;
  bool are_numbers = true;
  const auto take = [&](std::string_view word) {
    const std::optional<double> number = parse_number(word);
    are_numbers = are_numbers && number;
    if (are_numbers) numbers.push_back(*number);
  };
  if (!gaps.end_with_line) {
    for (int i = 0; i < words; ++i) take(scanner.word());
    return numbers;
  }
  for (std::string_view word = scanner.word_in_line(); !word.empty();
       word = scanner.word_in_line()) {
    take(word);
  }
  scanner.next_line();
  return numbers;
}

long long lines_with_words(TextScanner scanner) {
  long long lines = 0;
  while (scanner.next_line()) {
    if (!scanner.word_in_line().empty()) ++lines;
  }
  return lines;
}

bool skip_numbers(TextScanner& scanner, int count) {
  for (; count > 0; --count) {
    if (!parse_number(scanner.word())) return false;
  }
  return true;
}

bool skip_face(TextScanner& scanner, long long vertices) {
  const std::optional<long long> corners = parse_integer(scanner.word());
  if (!corners || *corners < 0) return false;
  for (long long i = 0; i < *corners; ++i) {
    const std::optional<long long> index = parse_integer(scanner.word());
    if (!index || *index < 0 || *index >= vertices) return false;
  }
  return true;
}

/// Whether the rest of the file is exactly the announced vertices and faces with these gaps.
bool fits(TextScanner scanner, const OffLayout& layout, const Counts& counts, const Gaps& gaps) {
  const int coordinates = layout.is_homogeneous ? 4 : 3;
  if (!skip_numbers(scanner, gaps.after_counts)) return false;
  for (long long v = 0; v < counts.vertices; ++v) {
    if (!skip_numbers(scanner, coordinates + gaps.after_vertex)) return false;
  }
  for (long long f = 0; f < counts.faces; ++f) {
    if (!skip_face(scanner, counts.vertices)) return false;
    if (!skip_numbers(scanner, gaps.after_face)) return false;
  }
  return scanner.word().empty();
}

/// Files with one vertex or face per line need no counting of numbers, and may have more of them
/// than their keyword says. Others wrap their lines anywhere: there, all numbers must be told.
Gaps find_gaps(const TextScanner& after_counts, const OffLayout& layout, const Counts& counts) {
  if (lines_with_words(after_counts) == counts.vertices + counts.faces) return {true};
  const int fixed = (layout.has_normal ? 3 : 0) + (layout.has_texture ? 2 : 0);
  for (const int edges : {1, 0}) {
    for (const int vertex_colour : {4, 3}) {  // with alpha or without
      for (const int face_colour : {0, 3, 4, 1}) {
        const Gaps gaps{false, false, edges, fixed + (layout.has_colour ? vertex_colour : 0),
                        face_colour};
        if (fits(after_counts, layout, counts, gaps)) return gaps;
      }
    }
  }
  return {};
}

/// The next number of a vertex or face; empty where it has a line of its own, which ends before:
/// what is missing there must not be taken from the next one.
std::string_view next_number(TextScanner& scanner, const Gaps& gaps) {
  return gaps.is_line_each ? scanner.word_in_line() : scanner.number_word();
}

/// One coordinate of a vertex; none where it is missing or no number.
double read_coordinate(TextScanner& scanner, const Gaps& gaps, SoupBuilder& builder) {
  const std::string_view word = next_number(scanner, gaps);
  if (!word.empty()) return builder.text_coordinate(word, scanner.line());
  builder.meet_fault({"truncated", here(scanner), {{"what", "coordinates"}}});
  return std::numeric_limits<double>::quiet_NaN();
}

void read_vertex(TextScanner& scanner, const OffLayout& layout, const Gaps& gaps,
                 SoupBuilder& builder) {
  const Place place = here(scanner);
  Vec3 position;
  for (double& coordinate : position) coordinate = read_coordinate(scanner, gaps, builder);
  if (layout.is_homogeneous) {
    const std::string_view word = next_number(scanner, gaps);
    const double w = word.empty() ? 0 : number_of(word, scanner.line());
    if (w == 0) builder.meet_fault({"not-finite", here(scanner), {{"what", "weight"}}});
    position /= w;
  }
  builder.add_vertex(position, place);
}

void read_face(TextScanner& scanner, const Gaps& gaps, SoupBuilder& builder) {
  const long long corners = scanner.integer();
  const Place place = here(scanner);
  for (long long i = 0; i < corners; ++i) {
    const std::string_view word = next_number(scanner, gaps);
    const std::optional<long long> index = parse_integer(word);
    if (index) {
      builder.add_corner(*index);
    } else if (word.empty()) {
      builder.add_lost_corner({"truncated", place, {{"what", "corners"}}});
      break;
    } else {
      builder.add_lost_corner(no_whole_number(word, scanner.line()));
    }
  }
  builder.end_face(place);
}

/// Goes on to the next word; false at the end of the file.
bool find_word(TextScanner& scanner) {
  TextScanner ahead = scanner;
  while (ahead.word_in_line().empty()) {
    if (!ahead.next_line()) return false;
    scanner = ahead;
  }
  return true;
}

void read_text(TextScanner scanner, const OffLayout& layout, SoupBuilder& builder) {
  const Counts counts = read_counts(scanner, layout);
  const Gaps gaps = find_gaps(scanner, layout, counts);
  builder.announce_faces(counts.faces);
  read_gap(scanner, gaps, gaps.after_counts);
  for (long long v = 0; v < counts.vertices; ++v) {
    if (!find_word(scanner)) fail_at_end(scanner, "vertices", v, counts.vertices);
    read_vertex(scanner, layout, gaps, builder);
    take_vertex_looks(read_gap(scanner, gaps, gaps.after_vertex), layout, builder);
  }
  for (long long f = 0; f < counts.faces; ++f) {
    if (!find_word(scanner)) fail_at_end(scanner, "faces", f, counts.faces);
    read_face(scanner, gaps, builder);
    take_face_looks(read_gap(scanner, gaps, gaps.after_face), builder);
  }
  if (find_word(scanner)) {
    const int rest = static_cast<int>(1 + lines_with_words(scanner));
    builder.note({"trailing-lines", rest});
  }
}

}  // namespace

PolygonSoup read_off(std::span<const std::byte> bytes) {
  TextScanner scanner(bytes);
  const OffLayout layout = read_off_header(scanner);
  if (layout.is_binary) return read_off_binary(bytes.subspan(scanner.position()), layout);
  refuse_nul(bytes);
  return build_soup(0, [&](SoupBuilder& builder) { read_text(scanner, layout, builder); });
}

}  // namespace foldwright
