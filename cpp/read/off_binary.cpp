#include "read/off_binary.h"

#include <cstdint>
#include <string>
#include <vector>

#include "mesh/input_error.h"
#include "read/byte_reader.h"
#include "read/off_looks.h"
#include "read/soup_builder.h"

namespace foldwright {
namespace {

class OffNumbers {
 public:
  explicit OffNumbers(std::span<const std::byte> bytes) : reader_(bytes, std::endian::big) {}

  std::int32_t integer() { return read<std::int32_t>(); }
  double number() { return read<float>(); }

  std::vector<double> numbers(long long count) {
    std::vector<double> values;
    for (; count > 0; --count) values.push_back(number());
    return values;
  }

  /// Tells what the next numbers belong to, for messages.
  void begin(const char* unit, long long index) { place_ = {unit, index}; }
  const Place& place() const { return place_; }

 private:
  ByteReader reader_;
  Place place_{"count", 0};

  template <typename T>
  T read() {
    if (reader_.left() < sizeof(T)) {
      throw InputError("truncated", place_, {{"what", "more"}});
    }
    return reader_.read<T>();
  }
};

int numbers_after_position(const OffLayout& layout) {
  return (layout.has_normal ? 3 : 0) + (layout.has_colour ? 4 : 0) + (layout.has_texture ? 2 : 0);
}

void read_vertex(OffNumbers& numbers, const OffLayout& layout, SoupBuilder& builder) {
  Vec3 position;
  for (double& coordinate : position) coordinate = builder.single_coordinate(numbers.number());
  if (layout.is_homogeneous) position /= numbers.number();
  const std::vector<double> looks = numbers.numbers(numbers_after_position(layout));
  builder.add_vertex(position, numbers.place());
  take_vertex_looks(looks, layout, builder);
}

void read_face(OffNumbers& numbers, SoupBuilder& builder) {
  const int corners = numbers.integer();
  for (int i = 0; i < corners; ++i) builder.add_corner(numbers.integer());
  const std::vector<double> colour = numbers.numbers(numbers.integer());
  builder.end_face(numbers.place());
  take_face_looks(colour, builder);
}

void read_numbers(std::span<const std::byte> bytes, const OffLayout& layout, SoupBuilder& builder) {
  const int counts = layout.has_dimension ? 4 : 3;
  if (bytes.size() < counts * sizeof(std::int32_t)) {
    throw InputError("truncated", {{"what", "header-only"}});
  }
  OffNumbers numbers(bytes);
  if (layout.has_dimension) require_three_dimensions(numbers.integer());
  const int vertices = numbers.integer();
  const int faces = numbers.integer();
  numbers.integer();  // the number of edges
  if (vertices < 0 || faces < 0) {
    throw InputError("bad-header", {{"what", "counts"}});
  }
  builder.announce_faces(faces);
  for (int v = 0; v < vertices; ++v) {
    numbers.begin("vertex", v);
    read_vertex(numbers, layout, builder);
  }
  for (int f = 0; f < faces; ++f) {
    numbers.begin("face", f);
    read_face(numbers, builder);
  }
}

}  // namespace

PolygonSoup read_off_binary(std::span<const std::byte> bytes, const OffLayout& layout) {
  return build_soup(0, [&](SoupBuilder& builder) { read_numbers(bytes, layout, builder); });
}

}  // namespace foldwright
