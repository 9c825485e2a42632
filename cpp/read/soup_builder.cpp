#include "read/soup_builder.h"

#include <utility>

#include "mesh/input_error.h"
#include "read/text_scanner.h"

namespace foldwright {

double SoupBuilder::text_coordinate(std::string_view word, int line) {
  const double value = number_of(word, line);
  precision_.add_text(word, value);
  return value;
}

double SoupBuilder::single_coordinate(double value) {
  precision_.add_single(value);
  return value;
}

double SoupBuilder::double_coordinate(double value) {
  precision_.add_double(value);
  return value;
}

void SoupBuilder::add_vertex(const Vec3& position, const Place& place) {
  if (!position.allFinite()) {
    throw InputError("not-finite", place, {{"what", "coordinate"}});
  }
  soup_.positions.push_back(position);
}

void SoupBuilder::end_face(const Place& place) {
  soup_.first_corner.push_back(static_cast<int>(corners_.size()));
  places_.push_back(place);
}

PolygonSoup SoupBuilder::finish() {
  if (soup_.face_count() == 0) {
    throw InputError("no-faces", {{"what", vertex_count() == 0 ? "nothing" : "vertices"}});
  }
  soup_.corners.reserve(corners_.size());
  for (int f = 0; f < soup_.face_count(); ++f) {
    for (int i = soup_.first_corner[f]; i < soup_.first_corner[f + 1]; ++i) {
      const long long index = corners_[i] - first_index_;
      if (index < 0 || index >= vertex_count()) {
        throw InputError("bad-index", places_[f],
                         {{"what", "beyond"},
                          {"index", corners_[i]},
                          {"vertices", vertex_count()},
                          {"first", first_index_}});
      }
      soup_.corners.push_back(static_cast<int>(index));
    }
  }
  soup_.precision = precision_.rounding_error();
  soup_.looks = looks_.finish(soup_);
  if (looks_.lost_places() > 0) note({"lost-picture-places", looks_.lost_places()});
  return std::move(soup_);
}

}  // namespace foldwright
