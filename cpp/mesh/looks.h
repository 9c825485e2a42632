#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "mesh/corner_origin.h"

namespace foldwright {

/// Red, green and blue as screens show them (sRGB).
using Rgb = std::array<std::uint8_t, 3>;

/// A place in a picture: (0, 0) is its lower left corner, (1, 1) its upper right one. Any number
/// is meant where the picture repeats; NaN stands for no place.
using PicturePlace = std::array<float, 2>;

/// How some faces look, by what they have at their corners and of which material they are.
struct FaceLooks {
  std::vector<PicturePlace> places;  ///< per corner, face by face; empty if no face has one
  std::vector<Rgb> colours;          ///< per corner, face by face; empty if no face has its own
  std::vector<int> materials;        ///< per face: a number, -1 for none; empty if no face has one

  bool empty() const { return places.empty() && colours.empty() && materials.empty(); }
};

/// How a file's surface looks. Corners and faces are those of the `PolygonSoup` that it is in.
struct SoupLooks : FaceLooks {
  std::vector<std::string> material_names;  ///< by number, where the file says names
  std::vector<std::string> libraries;       ///< what the file names as files of materials
  bool has_colour_numbers = false;          ///< colours of a table that the file does not hold
};

/// The looks of triangles whose corners come from these places of a file. Places in pictures and
/// colours are the means that the corners are, those of a material are all that face's.
/// \pre the origins are of the soup that has these looks; `first_corner` is that soup's
FaceLooks carry_looks(const FaceLooks& looks, std::span<const int> first_corner,
                      std::span<const FaceOrigins> origins);

}  // namespace foldwright
