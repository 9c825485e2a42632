#include <optional>

#include "mesh/formats.h"
#include "mesh/input_error.h"
#include "mesh/soup_builder.h"
#include "mesh/text_scanner.h"

namespace foldwright {
namespace {

Place here(const TextScanner& scanner) { return {"line", scanner.line()}; }

[[noreturn]] void fail(const TextScanner& scanner, const char* code, const std::string& sentence) {
  throw InputError(code, prefix(here(scanner)) + sentence);
}

/// Checks the header keyword and returns the number of vertices, the first number after it.
long long read_header(TextScanner& scanner) {
  const std::string_view first = scanner.word();
  if (const std::optional<long long> count = parse_integer(first)) return *count;  // no header
  std::string_view keyword = first;
  for (const char* attribute : {"ST", "C", "N"}) {
    if (keyword.starts_with(attribute)) keyword.remove_prefix(std::string_view(attribute).size());
  }
  if (keyword != "OFF") {
    fail(scanner, "bad-header",
         first.ends_with("OFF") ? quoted(first) + " files with more than 3 coordinates are not read"
                                : "an OFF file begins with OFF, this one with " + quoted(first));
  }
  const std::string_view next = scanner.word();
  if (next == "BINARY") fail(scanner, "bad-header", "binary OFF files are not read");
  if (next.empty()) fail(scanner, "truncated", "the file ends after its header");
  return integer_of(next, scanner.line());
}

/// The counts are never trusted with an allocation, only with this sentence.
[[noreturn]] void fail_at_end(const TextScanner& scanner, const char* what, long long done,
                              long long announced) {
  fail(scanner, "truncated",
       "the file ends after " + std::to_string(done) + " of " + std::to_string(announced) + " " +
           what);
}

/// Goes to the next line that has a word on it, and returns that word; empty at the end.
std::string_view first_word_of_next_line(TextScanner& scanner) {
  scanner.next_line();
  return scanner.word();
}

}  // namespace

PolygonSoup read_off(std::span<const std::byte> bytes) {
  TextScanner scanner(bytes);
  const long long vertices = read_header(scanner);
  const long long faces = scanner.integer();
  if (vertices < 0 || faces < 0) fail(scanner, "bad-header", "the counts must not be negative");

  // The number of edges, colours and normals end their lines and are skipped with them.
  SoupBuilder builder(0);
  for (long long v = 0; v < vertices; ++v) {
    const std::string_view x_word = first_word_of_next_line(scanner);
    if (x_word.empty()) fail_at_end(scanner, "vertices", v, vertices);
    const Place place = here(scanner);
    const double x = builder.text_coordinate(x_word, scanner.line());
    const double y = builder.text_coordinate(scanner.number_word(), scanner.line());
    const double z = builder.text_coordinate(scanner.number_word(), scanner.line());
    builder.add_vertex({x, y, z}, place);
  }
  for (long long f = 0; f < faces; ++f) {
    const std::string_view count_word = first_word_of_next_line(scanner);
    if (count_word.empty()) fail_at_end(scanner, "faces", f, faces);
    const Place place = here(scanner);
    const long long corners = integer_of(count_word, scanner.line());
    for (long long i = 0; i < corners; ++i) builder.add_corner(scanner.integer());
    builder.end_face(place);
  }
  return builder.finish();
}

}  // namespace foldwright
