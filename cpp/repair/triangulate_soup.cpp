#include "repair/triangulate_soup.h"

#include <algorithm>
#include <string>
#include <utility>

#include "mesh/input_error.h"
#include "repair/triangulate.h"

namespace foldwright {
namespace {

/// Cutting takes quadratic time, and this many corners about a second. Nothing that is to be made
/// of paper has such a face.
constexpr int kMostCorners = 10'000;

/// A corner of a polygon.
struct Corner {
  int vertex;
  int index;  ///< in its face, as the file gives it
};
using Ring = std::vector<Corner>;

bool meet(const Corner& a, const Corner& b) { return a.vertex == b.vertex; }

/// The polygon without repeated corners and spikes.
Ring clean(const Ring& polygon) {
  Ring ring;
  for (const Corner& corner : polygon) {
    if (!ring.empty() && meet(ring.back(), corner)) continue;
    if (ring.size() >= 2 && meet(ring[ring.size() - 2], corner)) {
      ring.pop_back();
    } else {
      ring.push_back(corner);
    }
  }
  // The same across the seam.
  std::size_t begin = 0;
  while (ring.size() - begin >= 2) {
    const std::size_t size = ring.size();
    if (meet(ring[begin], ring.back()) || meet(ring[begin], ring[size - 2])) {
      ring.pop_back();
    } else if (meet(ring[begin + 1], ring.back())) {
      ++begin;
    } else {
      break;
    }
  }
  ring.erase(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(begin));
  return ring;
}

/// Turns the ring to a beginning and a direction that depend on its vertices alone. Returns whether
/// the direction is now the other one.
bool make_canonical(Ring& ring) {
  const auto lowest = std::ranges::min_element(ring, {}, &Corner::vertex);
  std::rotate(ring.begin(), lowest, ring.end());
  const bool reversed = ring.back().vertex < ring[1].vertex;
  if (reversed) std::reverse(ring.begin() + 1, ring.end());
  return reversed;
}

void add_polygon(TriangleSoup& triangles, Ring ring, int source_face) {
  const bool reversed = make_canonical(ring);
  std::vector<Vec3> points;
  for (const Corner& corner : ring) points.push_back(triangles.positions[corner.vertex]);
  for (auto [i, j, k] : triangulate(points)) {
    if (meet(ring[i], ring[j]) || meet(ring[j], ring[k]) || meet(ring[k], ring[i])) continue;
    if (reversed) std::swap(j, k);
    triangles.faces.push_back({ring[i].vertex, ring[j].vertex, ring[k].vertex});
    triangles.source_faces.push_back(source_face);
    triangles.origins.push_back(
        origins_of_triangle(source_face, {ring[i].index, ring[j].index, ring[k].index}));
  }
}

}  // namespace

TriangleSoup triangulate_soup(const PolygonSoup& soup, std::span<const int> vertex_of,
                              std::vector<Vec3> positions) {
  TriangleSoup triangles;
  triangles.positions = std::move(positions);
  Ring polygon;
  for (int f = 0; f < soup.face_count(); ++f) {
    polygon.clear();
    for (int i = soup.first_corner[f]; i < soup.first_corner[f + 1]; ++i) {
      polygon.push_back({vertex_of[soup.corners[i]], i - soup.first_corner[f]});
    }
    Ring ring = clean(polygon);
    if (ring.size() < 3) continue;
    if (ring.size() > kMostCorners) {
      throw InputError("too-many-corners",
                       {{"face", f + 1}, {"corners", ring.size()}, {"most", kMostCorners}});
    }
    add_polygon(triangles, std::move(ring), f);
  }
  return triangles;
}

}  // namespace foldwright
