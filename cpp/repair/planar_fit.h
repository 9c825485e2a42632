#pragma once

#include <span>

#include "repair/triangle_soup.h"

namespace foldwright {

/// The plane of some triangles.
struct PlanarFit {
  Vec3 centre;           ///< mean of the corners
  Vec3 normal;           ///< unit; the mean of the faces' by area
  double area = 0;       ///< of all faces
  double deviation = 0;  ///< of the corner furthest off the plane
  double extent = 0;     ///< distance of the corner furthest from the centre, twice
  bool upright = true;   ///< no face has its back up
};

/// Fits a plane to faces by their area; its height is halfway between the corners furthest below
/// and above it. \pre there is a face, and the faces' area vectors do not cancel out
PlanarFit fit_plane(const TriangleSoup& soup, std::span<const int> faces);

}  // namespace foldwright
