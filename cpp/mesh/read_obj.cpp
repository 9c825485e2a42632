#include "mesh/formats.h"
#include "mesh/input_error.h"
#include "mesh/soup_builder.h"
#include "mesh/text_scanner.h"

namespace foldwright {
namespace {

Place here(const TextScanner& scanner) { return {"line", scanner.line()}; }

double coordinate(TextScanner& scanner, SoupBuilder& builder) {
  const std::string_view word = scanner.word_in_line();
  if (word.empty()) {
    throw InputError("truncated", prefix(here(scanner)) + "vertex has fewer than 3 coordinates");
  }
  return builder.text_coordinate(word, scanner.line());
}

/// A corner such as "7", "7/1", "7//2" or "-1/-1/-1"; only the vertex counts.
void add_corner(SoupBuilder& builder, std::string_view word, const Place& place) {
  const std::string_view vertex = word.substr(0, word.find('/'));
  const long long index = integer_of(vertex, static_cast<int>(place.number));
  if (index >= 0) return builder.add_corner(index);
  const long long absolute = builder.vertex_count() + 1 + index;
  if (absolute < 1) {
    throw InputError("bad-index", prefix(place) + "face refers to vertex " + std::to_string(index) +
                                      ", but only " + std::to_string(builder.vertex_count()) +
                                      " vertices come before it");
  }
  builder.add_corner(absolute);
}

void read_face(TextScanner& scanner, SoupBuilder& builder) {
  const Place place = here(scanner);
  int corners = 0;
  for (std::string_view word = scanner.word_in_line(); !word.empty();
       word = scanner.word_in_line()) {
    add_corner(builder, word, place);
    ++corners;
  }
  // A short face elsewhere is one bad face; at the very end, without a line break, it tells that
  // the rest of the file is missing.
  if (corners < 3 && scanner.at_end()) {
    throw InputError("truncated", prefix(place) + "the file ends in the middle of a face");
  }
  builder.end_face(place);
}

}  // namespace

PolygonSoup read_obj(std::span<const std::byte> bytes) {
  TextScanner scanner(bytes, LineContinuation::kBackslash);
  SoupBuilder builder(1);
  do {
    const std::string_view keyword = scanner.word_in_line();
    if (keyword == "v") {
      const Place place = here(scanner);
      const double x = coordinate(scanner, builder);
      const double y = coordinate(scanner, builder);
      const double z = coordinate(scanner, builder);
      builder.add_vertex({x, y, z}, place);
    } else if (keyword == "f" || keyword == "fo") {  // "fo": faces of old exporters
      read_face(scanner, builder);
    }
  } while (scanner.next_line());
  return builder.finish();
}

}  // namespace foldwright
