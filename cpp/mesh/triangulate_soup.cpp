#include "mesh/triangulate_soup.h"

#include <algorithm>
#include <string>
#include <utility>

#include "mesh/input_error.h"
#include "mesh/triangulate.h"

namespace foldwright {
namespace {

/// Cutting takes quadratic time, and this many corners about a second. Nothing that is to be made
/// of paper has such a face.
constexpr int kMostCorners = 10'000;

/// The polygon without repeated corners and spikes.
std::vector<int> clean(const std::vector<int>& polygon) {
  std::vector<int> ring;
  for (const int vertex : polygon) {
    if (!ring.empty() && ring.back() == vertex) continue;
    if (ring.size() >= 2 && ring[ring.size() - 2] == vertex) {
      ring.pop_back();
    } else {
      ring.push_back(vertex);
    }
  }
  // The same across the seam.
  std::size_t begin = 0;
  while (ring.size() - begin >= 2) {
    const std::size_t size = ring.size();
    if (ring[begin] == ring.back() || ring[begin] == ring[size - 2]) {
      ring.pop_back();
    } else if (ring[begin + 1] == ring.back()) {
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
bool make_canonical(std::vector<int>& ring) {
  std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
  const bool reversed = ring.back() < ring[1];
  if (reversed) std::reverse(ring.begin() + 1, ring.end());
  return reversed;
}

void add_polygon(TriangleSoup& triangles, std::vector<int> ring, int source_face) {
  const bool reversed = make_canonical(ring);
  std::vector<Vec3> points;
  for (const int vertex : ring) points.push_back(triangles.positions[vertex]);
  for (auto [i, j, k] : triangulate(points)) {
    if (ring[i] == ring[j] || ring[j] == ring[k] || ring[k] == ring[i]) continue;
    if (reversed) std::swap(j, k);
    triangles.faces.push_back({ring[i], ring[j], ring[k]});
    triangles.source_faces.push_back(source_face);
  }
}

}  // namespace

TriangleSoup triangulate_soup(const PolygonSoup& soup, std::span<const int> vertex_of,
                              std::vector<Vec3> positions) {
  TriangleSoup triangles;
  triangles.positions = std::move(positions);
  std::vector<int> polygon;
  for (int f = 0; f < soup.face_count(); ++f) {
    polygon.clear();
    for (int i = soup.first_corner[f]; i < soup.first_corner[f + 1]; ++i) {
      polygon.push_back(vertex_of[soup.corners[i]]);
    }
    std::vector<int> ring = clean(polygon);
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
