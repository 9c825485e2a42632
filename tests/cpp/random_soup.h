#pragma once

#include "geometry/random.h"
#include "meshes.h"

namespace foldwright::testing {

/// Polygons between few lattice points, so that faces coincide, touch and degenerate in every way.
inline PolygonSoup random_soup(std::uint64_t seed) {
  Random random(seed);
  const int side = 2 + random.below(3);
  std::vector<Vec3> positions;
  for (int i = 0; i < side * side * side; ++i) {
    positions.emplace_back(i % side, i / side % side, i / side / side);
  }
  std::vector<std::vector<int>> polygons(1 + random.below(60));
  for (std::vector<int>& polygon : polygons) {
    const int corners = random.below(4) == 0 ? random.below(9) : 3;
    for (int i = 0; i < corners; ++i) {
      polygon.push_back(random.below(static_cast<int>(positions.size())));
    }
  }
  return soup(positions, polygons);
}

}  // namespace foldwright::testing
