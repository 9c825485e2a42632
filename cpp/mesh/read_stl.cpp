#include <cstdint>

#include "mesh/byte_reader.h"
#include "mesh/formats.h"
#include "mesh/input_error.h"
#include "mesh/soup_builder.h"
#include "mesh/text_scanner.h"

namespace foldwright {
namespace {

constexpr std::size_t kHeaderSize = 84;    // free text of 80 bytes, then the number of triangles
constexpr std::size_t kTriangleSize = 50;  // normal, three corners, two bytes of attributes

ByteReader after_free_text(std::span<const std::byte> bytes) {
  return {bytes.subspan(kHeaderSize - 4), std::endian::little};
}

bool is_ascii(std::span<const std::byte> bytes) {
  if (bytes.size() >= kHeaderSize) {
    const std::size_t count = after_free_text(bytes).read<std::uint32_t>();
    if (kHeaderSize + count * kTriangleSize == bytes.size()) return false;
  }
  // Many binary headers begin with "solid" as well, but no text has a NUL byte near its beginning.
  constexpr std::size_t kSample = 512;
  const std::span sample = bytes.first(std::min(bytes.size(), kSample));
  return lower_case(TextScanner(bytes).word()) == "solid" &&
         std::find(sample.begin(), sample.end(), std::byte{0}) == sample.end();
}

void add_triangle(ByteReader& reader, SoupBuilder& builder, long long number) {
  const Place place{"triangle", number};
  reader.skip(3 * sizeof(float));  // the normal: often zero or wrong, and never needed
  for (int corner = 0; corner < 3; ++corner) {
    const double x = builder.single_coordinate(reader.read<float>());
    const double y = builder.single_coordinate(reader.read<float>());
    const double z = builder.single_coordinate(reader.read<float>());
    builder.add_vertex({x, y, z}, place);
    builder.add_corner(builder.vertex_count() - 1);
  }
  reader.skip(2);
  builder.end_face(place);
}

PolygonSoup read_binary(std::span<const std::byte> bytes) {
  if (bytes.size() < kHeaderSize) {
    throw InputError("truncated", "the file has " + std::to_string(bytes.size()) +
                                      " bytes, too few for the header of a binary STL");
  }
  ByteReader reader = after_free_text(bytes);
  const long long announced = reader.read<std::uint32_t>();
  const long long present = static_cast<long long>(reader.left() / kTriangleSize);
  if (announced > present) {
    throw InputError("truncated", "triangle " + std::to_string(present + 1) +
                                      ": the file ends here, but its header announces " +
                                      std::to_string(announced) + " triangles");
  }
  // A stale count before whole records is what exporters leave that stream their output.
  const bool stale_count = announced < present && reader.left() % kTriangleSize == 0;
  const long long count = stale_count ? present : announced;
  SoupBuilder builder(0);
  for (long long t = 1; t <= count; ++t) add_triangle(reader, builder, t);
  if (stale_count) {
    builder.note({"wrong-count", static_cast<int>(present - announced),
                  "the header announces " + std::to_string(announced) + " triangles, but all " +
                      std::to_string(present) + " in the file were read"});
  } else if (reader.left() > 0) {
    builder.note({"trailing-bytes", static_cast<int>(reader.left()),
                  std::to_string(reader.left()) + " bytes after the last triangle were ignored"});
  }
  return builder.finish();
}

[[noreturn]] void fail_unexpected(const TextScanner& scanner, std::string_view word,
                                  const char* expected) {
  const Place place{"line", scanner.line()};
  if (scanner.at_end()) {  // the last word may be half of the expected one
    throw InputError("truncated",
                     prefix(place) + "the file ends where '" + expected + "' is expected");
  }
  throw InputError("bad-syntax",
                   prefix(place) + quoted(word) + " stands where '" + expected + "' is expected");
}

void expect(TextScanner& scanner, const char* expected) {
  const std::string_view word = scanner.word();
  if (lower_case(word) != expected) fail_unexpected(scanner, word, expected);
}

/// A facet after its first word, with any number of corners.
void read_facet(TextScanner& scanner, SoupBuilder& builder) {
  const Place place{"line", scanner.line()};
  scanner.next_line();  // the normal: often zero, wrong or NaN, and never needed
  expect(scanner, "outer");
  expect(scanner, "loop");
  std::string_view word = scanner.word();
  for (; lower_case(word) == "vertex"; word = scanner.word()) {
    const Place vertex_place{"line", scanner.line()};
    const double x = builder.text_coordinate(scanner.number_word(), scanner.line());
    const double y = builder.text_coordinate(scanner.number_word(), scanner.line());
    const double z = builder.text_coordinate(scanner.number_word(), scanner.line());
    builder.add_vertex({x, y, z}, vertex_place);
    builder.add_corner(builder.vertex_count() - 1);
  }
  if (lower_case(word) != "endloop") fail_unexpected(scanner, word, "endloop");
  expect(scanner, "endfacet");
  builder.end_face(place);
}

PolygonSoup read_ascii(std::span<const std::byte> bytes) {
  TextScanner scanner(bytes);
  SoupBuilder builder(0);
  bool in_solid = false;
  for (std::string_view word = scanner.word(); !word.empty(); word = scanner.word()) {
    const std::string keyword = lower_case(word);
    if (keyword == "facet") {
      read_facet(scanner, builder);
    } else if (keyword == "solid" || keyword == "endsolid") {
      in_solid = keyword == "solid";
      scanner.next_line();  // the solid's name may be anything
    } else {
      fail_unexpected(scanner, word, "facet");
    }
  }
  if (in_solid) {
    builder.note({"missing-endsolid", 1,
                  "the file ends without 'endsolid'; triangles may be missing at its end"});
  }
  return builder.finish();
}

}  // namespace

PolygonSoup read_stl(std::span<const std::byte> bytes) {
  return is_ascii(bytes) ? read_ascii(bytes) : read_binary(bytes);
}

}  // namespace foldwright
