#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mesh/message.h"
#include "mesh/polygon_soup.h"
#include "read/coordinate_precision.h"
#include "read/looks_builder.h"

namespace foldwright {

/// Collects what a reader finds and checks it, so that all formats fail with the same messages.
class SoupBuilder {
 public:
  /// `first_index`: the number of the first vertex in the format, 0 or 1.
  explicit SoupBuilder(int first_index) : first_index_(first_index) {}

  /// A coordinate that is written as text; how finely it is written counts for the precision.
  /// \throw InputError ("bad-number") naming the line
  double text_coordinate(std::string_view word, int line);
  /// A coordinate that is stored as a float, or as a double or a whole number.
  double single_coordinate(double value);
  double double_coordinate(double value);

  /// \throw InputError ("not-finite") when a coordinate is NaN or infinite
  void add_vertex(const Vec3& position, const Place& place);
  /// Adds a corner to the face being collected; `index` counts vertices as the format does. Whether
  /// the vertex exists is checked by `finish`, since it may come later in the file.
  void add_corner(long long index) { corners_.push_back(index); }
  /// Ends the face being collected, with as many corners as were added.
  void end_face(const Place& place);
  /// What the file says of how its vertices, corners and faces look, by their numbers from 0.
  LooksBuilder& looks() { return looks_; }
  void note(Repair repair) { soup_.repairs.push_back(std::move(repair)); }

  int vertex_count() const { return static_cast<int>(soup_.positions.size()); }
  int face_count() const { return soup_.face_count(); }
  /// Of all faces, the one that is being collected included, and without that one.
  std::size_t corner_count() const { return corners_.size(); }
  std::size_t ended_corner_count() const {
    return static_cast<std::size_t>(soup_.first_corner.back());
  }

  /// \throw InputError ("bad-index", "no-faces") naming the place
  PolygonSoup finish();

 private:
  int first_index_;
  PolygonSoup soup_;
  CoordinatePrecision precision_;
  LooksBuilder looks_;
  std::vector<long long> corners_;
  std::vector<Place> places_;  // per face
};

}  // namespace foldwright
