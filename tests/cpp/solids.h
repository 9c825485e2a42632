#pragma once

#include <string>
#include <vector>

#include "mesh/polygon_soup.h"

namespace foldwright::testing {

/// A solid as somebody draws it: polygons with any number of corners.
struct Solid {
  std::string name;
  std::vector<Vec3> positions;
  std::vector<std::vector<int>> polygons;
  int panels = 0;  ///< as many flat regions as it has
};

/// A prism along z over a polygon, counter-clockwise seen from above.
Solid prism_over(std::string name, const std::vector<Vec2>& base, double depth);

/// Cube, dodecahedron, prism over an L, tube of 16 sides, torus of 8 x 6 quads, tent, and a figure
/// of voxels, most about 2 across.
std::vector<Solid> drawn_solids();

/// As a reader would deliver it, with coordinates that may be off by `precision`.
PolygonSoup soup_of(const Solid& solid, double precision);

}  // namespace foldwright::testing
