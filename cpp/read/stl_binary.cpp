#include "read/stl_binary.h"

#include <cstdint>
#include <limits>
#include <optional>
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

/// How a vendor's programs write colours into the attributes of triangles: 5 bits for each part of
/// a colour, and the highest bit.
struct ColourBits {
  int red, green, blue;        // place of the lowest of their bits
  bool when_set;               // what the highest bit is where a triangle has a colour of its own
  std::optional<Vec3> common;  // of all triangles without a colour of their own
};

/// One vendor's programs name a colour for all in the free text, and mean the opposite of others
/// with the highest bit and the order.
ColourBits colour_bits(std::span<const std::byte> bytes) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), kHeaderSize - 4);
  constexpr std::string_view kKey = "COLOR=";
  const std::size_t key = text.find(kKey);
  if (key == std::string_view::npos || key + kKey.size() + 3 > text.size()) {
    return {10, 5, 0, true, std::nullopt};
  }
  Vec3 common;
  for (int k = 0; k < 3; ++k) {
    common[k] = static_cast<unsigned char>(text[key + kKey.size() + k]) / 255.0;
  }
  return {0, 5, 10, false, common};
}

void add_colour(unsigned attributes, const ColourBits& bits, SoupBuilder& builder) {
  const int face = builder.face_count() - 1;
  if (((attributes & 0x8000u) != 0) != bits.when_set) {
    if (bits.common) builder.looks().colour_face(face, *bits.common);
    return;
  }
  constexpr double kFull = 31;
  const auto part = [&](int shift) { return ((attributes >> shift) & 31u) / kFull; };
  builder.looks().colour_face(face, {part(bits.red), part(bits.green), part(bits.blue)});
}

void add_triangle(ByteReader& reader, const ColourBits& bits, SoupBuilder& builder,
                  long long number) {
  const Place place{"triangle", number};
  reader.skip(3 * sizeof(float));  // the normal: often zero or wrong, and never needed
  for (int corner = 0; corner < 3; ++corner) {
    const double x = builder.single_coordinate(reader.read<float>());
    const double y = builder.single_coordinate(reader.read<float>());
    const double z = builder.single_coordinate(reader.read<float>());
    builder.add_vertex({x, y, z}, place);
    builder.add_corner(builder.vertex_count() - 1);
  }
  builder.end_face(place);
  add_colour(reader.read<std::uint16_t>(), bits, builder);
}

int clamped(long long count) {
  return static_cast<int>(std::min<long long>(count, std::numeric_limits<int>::max()));
}

void read_triangles(std::span<const std::byte> bytes, SoupBuilder& builder) {
  if (bytes.size() < kHeaderSize) {
    throw InputError("truncated", {{"what", "stl-header"}, {"bytes", bytes.size()}});
  }
  ByteReader reader = after_free_text(bytes);
  const long long announced = reader.read<std::uint32_t>();
  const long long present = static_cast<long long>(reader.left() / kTriangleSize);
  const bool ends_whole = reader.left() % kTriangleSize == 0;
  // Exporters that stream their output leave any count before whole triangles, mostly 0.
  const bool wrong_count = announced != present && (ends_whole || announced == 0);
  const long long count = std::min(wrong_count ? present : announced, present);
  builder.announce_faces(announced);
  const ColourBits bits = colour_bits(bytes);
  for (long long t = 1; t <= count; ++t) add_triangle(reader, bits, builder, t);
  if (announced > present && !ends_whole) {
    throw InputError("truncated", Place{"triangle", present + 1},
                     {{"what", "triangles"}, {"announced", announced}});
  }
  if (wrong_count) {
    builder.note({"wrong-count", clamped(present), {{"announced", announced}}});
  }
  if (reader.left() > 0) {
    builder.note({"trailing-bytes", clamped(static_cast<long long>(reader.left()))});
  }
}

}  // namespace

bool has_size_of_binary_stl(std::span<const std::byte> bytes) {
  if (bytes.size() < kHeaderSize) return false;
  const std::uint64_t count = after_free_text(bytes).read<std::uint32_t>();
  return kHeaderSize + count * kTriangleSize == bytes.size();
}

PolygonSoup read_stl_binary(std::span<const std::byte> bytes) {
  return build_soup(0, [&](SoupBuilder& builder) { read_triangles(bytes, builder); });
}

}  // namespace foldwright
