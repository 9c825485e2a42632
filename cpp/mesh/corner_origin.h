#pragma once

#include <array>

#include "geometry/vec.h"

namespace foldwright {

struct PolygonSoup;

/// The place in a file that a corner of a face comes from: a weighted mean of three corners of one
/// face of the file. Whatever the file gives at its corners (positions, texture coordinates,
/// colours) has this mean there.
struct CornerOrigin {
  int face = -1;                           ///< of the file as read: index in `PolygonSoup`
  std::array<int, 3> corners = {0, 0, 0};  ///< of that face, counted from 0; all different
  /// Of these corners, from 0 to 1; they add up to 1. One of them is 1 where the corner is one of
  /// the file's own.
  Vec3 weights = Vec3::Zero();
};

/// The origins of the three corners of a triangle, in the order of its corners.
using FaceOrigins = std::array<CornerOrigin, 3>;

/// Of a triangle between three corners of a face of the file.
FaceOrigins origins_of_triangle(int face, const std::array<int, 3>& corners);

/// The place at a share of the way from one place to another.
/// \pre both are means of the same three corners of one face
CornerOrigin place_between(const CornerOrigin& from, const CornerOrigin& to, double share);

/// The place within a triangle at barycentric coordinates, which are not negative and add up to 1.
/// \pre the corners of the triangle are means of the same three corners of one face
CornerOrigin place_within(const FaceOrigins& triangle, const Vec3& coordinates);

/// Where a place lies in space, in the coordinates of the file's own polygons.
Vec3 position_at(const PolygonSoup& soup, const CornerOrigin& origin);

}  // namespace foldwright
