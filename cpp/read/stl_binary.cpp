#include "read/stl_binary.h"

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

#include "mesh/input_error.h"
#include "read/byte_reader.h"
#include "read/soup_builder.h"

namespace foldwright {
namespace {

constexpr std::size_t kHeaderSize = 84;    // free text of 80 bytes, then the number of triangles
constexpr std::size_t kTriangleSize = 50;  // normal, three corners, two bytes of attributes

ByteReader after_free_text(std::span<const std::byte> bytes) {
  return {bytes.subspan(kHeaderSize - 4), std::endian::little};
}

/// Whether the free text gives the whole model a colour, as one vendor's programs do; in their
/// files the bit of a triangle means the opposite, but then all have colours anyway.
bool names_colour(std::span<const std::byte> bytes) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), kHeaderSize - 4);
  return text.find("COLOR=") != std::string_view::npos;
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
  // The highest bit says that the others are a colour. Without it they may be anything.
  if ((reader.read<std::uint16_t>() & 0x8000u) != 0) builder.skip_colours();
  builder.end_face(place);
}

int clamped(long long count) {
  return static_cast<int>(std::min<long long>(count, std::numeric_limits<int>::max()));
}

}  // namespace

bool has_size_of_binary_stl(std::span<const std::byte> bytes) {
  if (bytes.size() < kHeaderSize) return false;
  const std::uint64_t count = after_free_text(bytes).read<std::uint32_t>();
  return kHeaderSize + count * kTriangleSize == bytes.size();
}

PolygonSoup read_stl_binary(std::span<const std::byte> bytes) {
  if (bytes.size() < kHeaderSize) {
    throw InputError("truncated", {{"what", "stl-header"}, {"bytes", bytes.size()}});
  }
  ByteReader reader = after_free_text(bytes);
  const long long announced = reader.read<std::uint32_t>();
  const long long present = static_cast<long long>(reader.left() / kTriangleSize);
  const bool ends_whole = reader.left() % kTriangleSize == 0;
  if (announced > present && !ends_whole) {
    throw InputError("truncated", Place{"triangle", present + 1},
                     {{"what", "triangles"}, {"announced", announced}});
  }
  // Exporters that stream their output leave any count before whole triangles, mostly 0.
  const bool wrong_count = announced != present && (ends_whole || announced == 0);
  const long long count = wrong_count ? present : announced;
  SoupBuilder builder(0);
  if (names_colour(bytes)) builder.skip_colours();
  for (long long t = 1; t <= count; ++t) add_triangle(reader, builder, t);
  if (wrong_count) {
    builder.note({"wrong-count", clamped(present), {{"announced", announced}}});
  }
  if (reader.left() > 0) {
    builder.note({"trailing-bytes", clamped(static_cast<long long>(reader.left()))});
  }
  return builder.finish();
}

}  // namespace foldwright
