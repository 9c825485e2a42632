#include "read/off_looks.h"

namespace foldwright {

void take_vertex_looks(std::span<const double> numbers, const OffLayout& layout,
                       SoupBuilder& builder) {
  const std::size_t normal = layout.has_normal ? 3 : 0;
  const std::size_t place = layout.has_texture ? 2 : 0;
  if (numbers.size() < normal + place) return;
  const std::span<const double> colour = numbers.subspan(normal, numbers.size() - normal - place);
  const int vertex = builder.vertex_count() - 1;
  LooksBuilder& looks = builder.looks();
  if (layout.has_colour && colour.size() >= 3) {
    looks.colour_vertex(vertex, {colour[0], colour[1], colour[2]});
  }
  if (layout.has_texture) {
    const std::span<const double> last = numbers.last(2);
    looks.place_vertex(vertex, {static_cast<float>(last[0]), static_cast<float>(last[1])});
  }
}

void take_face_looks(std::span<const double> numbers, SoupBuilder& builder) {
  if (numbers.size() >= 3) {
    builder.looks().colour_face(builder.face_count() - 1, {numbers[0], numbers[1], numbers[2]});
  } else if (numbers.size() == 1) {
    builder.looks().meet_colour_number();
  }
}

}  // namespace foldwright
