#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/vec.h"
#include "mesh/polygon_soup.h"

namespace foldwright {

/// Collects what a reader finds of a surface's looks. What is not said of a corner or a face is
/// unknown there.
class LooksBuilder {
 public:
  /// A place in pictures that corners name by its number, counted from 0 in the order of adding.
  void add_place(const PicturePlace& place) { listed_places_.push_back(place); }
  int place_count() const { return static_cast<int>(listed_places_.size()); }
  /// `corner` counts all corners of the file; whether the number exists is seen by `finish`, since
  /// it may come later in the file.
  void name_place(std::size_t corner, long long number);
  /// The numbers named so far are one too low: the file counts from 0 where its format does from 1.
  void count_places_from_zero() { place_offset_ = 1; }
  void place_corner(std::size_t corner, const PicturePlace& place);
  void place_vertex(int vertex, const PicturePlace& place);

  /// Colours as the file has them: from 0 to 1, or to 255 if one number of the file is above 1.
  void colour_vertex(int vertex, const Vec3& colour);
  /// Counts where the vertices of the face have none.
  void colour_face(int face, const Vec3& colour);
  void meet_colour_number() { looks_.has_colour_numbers = true; }

  void set_material(int face, int number);
  /// The number of the material of that name.
  int material_named(std::string_view name);
  void add_library(std::string_view name) { looks_.libraries.emplace_back(name); }

  /// \pre the soup's corners and faces are complete
  SoupLooks finish(const PolygonSoup& soup);
  /// Corners whose place does not exist; known once all is finished.
  int lost_places() const { return lost_places_; }

 private:
  std::vector<PicturePlace> listed_places_;
  std::vector<long long> place_numbers_;  ///< per corner
  std::vector<PicturePlace> corner_places_, vertex_places_;
  std::vector<std::optional<Vec3>> vertex_colours_, face_colours_;
  long long place_offset_ = 0;
  double largest_ = 0;  ///< of all numbers of colours
  std::map<std::string, int, std::less<>> materials_;
  SoupLooks looks_;
  int lost_places_ = 0;

  PicturePlace place_of(std::size_t corner, int vertex);
  Rgb rgb(const Vec3& colour) const;
  Rgb colour_of(int vertex, int face) const;
};

}  // namespace foldwright
