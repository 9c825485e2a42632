#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/input_error.h"
#include "mesh/message.h"
#include "mesh/polygon_soup.h"
#include "read/coordinate_precision.h"
#include "read/looks_builder.h"

namespace foldwright {

/// Collects what a reader finds and checks it, so that all formats fail with the same messages.
///
/// A fault of one vertex or face costs the faces that it touches and no others: they keep their
/// numbers, lose their corners, and are told by a repair. The first fault is what the file is
/// refused for if it leaves too little of it.
class SoupBuilder {
 public:
  /// `first_index`: the number of the first vertex in the format, 0 or 1.
  explicit SoupBuilder(int first_index) : first_index_(first_index) {}

  /// A coordinate that is written as text; how finely it is written counts for the precision. NaN
  /// where the word is no number.
  double text_coordinate(std::string_view word, int line);
  /// A coordinate that is stored as a float, or as a double or a whole number.
  double single_coordinate(double value);
  double double_coordinate(double value);

  /// A vertex with a coordinate that is NaN or infinite has no place.
  void add_vertex(const Vec3& position, const Place& place);
  /// Adds a corner to the face being collected; `index` counts vertices as the format does. Whether
  /// the vertex exists is checked by `finish`, since it may come later in the file.
  void add_corner(long long index) { corners_.push_back(index); }
  /// Notes what is wrong with a vertex or with a number of the face being collected.
  void meet_fault(const InputError& fault);
  /// Adds a corner that is no vertex, for what `fault` says.
  void add_lost_corner(const InputError& fault);
  /// Ends the face being collected, with as many corners as were added.
  void end_face(const Place& place);
  /// How many faces the file says that it has.
  void announce_faces(long long count) { announced_faces_ = count; }
  /// The file ends here, though it should go on: what was collected of a face is dropped.
  void end_early(const InputError& fault);
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

  /// \throw InputError the first fault, if more than half of the faces are lost by faults or by the
  /// end of the file, or "no-faces"
  PolygonSoup finish();

 private:
  int first_index_;
  PolygonSoup soup_;
  CoordinatePrecision precision_;
  LooksBuilder looks_;
  std::vector<long long> corners_;
  std::vector<Place> places_;    // per face
  std::vector<char> has_place_;  // per vertex
  std::optional<InputError> first_fault_;
  std::optional<Place> first_placeless_;  // vertex
  std::optional<Parameters> end_;         // the place where a file is cut off
  long long announced_faces_ = 0;
  int decimal_commas_ = 0;

  bool counts_from_zero() const;
  void resolve_corners();
  std::vector<char> find_unusable_faces();
  void require_enough(int unusable) const;
  void drop_corners(const std::vector<char>& unusable);
};

/// What `read` puts into a builder. Where it throws "truncated", the file is cut off there, and
/// what came before is used.
/// \throw InputError whatever else `read` throws, or the builder's `finish`
PolygonSoup build_soup(int first_index, const std::function<void(SoupBuilder&)>& read);

}  // namespace foldwright
