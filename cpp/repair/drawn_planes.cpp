#include "repair/drawn_planes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <span>

#include "geometry/union_find.h"
#include "mesh/dual_graph.h"
#include "repair/edge_groups.h"
#include "repair/planar_fit.h"

namespace foldwright {
namespace {

const double kRoot3 = std::sqrt(3.0);  // all three coordinates of a vertex may be off

// A polygon is flat if it leaves its plane by this share of its extent: a tenth of a millimetre on
// ten centimetres, which paper does not show.
constexpr double kMeantFlat = 1e-3;

// Whatever the precision, a polygon that leaves its plane by more of its extent is not flat.
constexpr double kClearlyBent = 0.05;

// Between polygons a crease of more than this is genuine, however coarse the file is.
constexpr double kGentleCrease = std::numbers::pi / 180;

/// Faces that stay together whatever plane they come to lie in: a flat polygon, or a triangle.
struct Tile {
  std::vector<int> faces;  ///< ascending
  PlanarFit fit;
};

double angle_between(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

double largest_error(const TriangleSoup& soup, std::span<const int> faces) {
  double largest = 0;
  for (const int face : faces) {
    for (const int v : soup.faces[face]) largest = std::max(largest, soup.error(v));
  }
  return largest;
}

/// How far the corners of a polygon may lie off a plane fitted to all of them: their own errors,
/// and about as much for the plane's.
double fit_error(const TriangleSoup& soup, std::span<const int> faces) {
  return 2 * kRoot3 * largest_error(soup, faces);
}

bool is_flat_polygon(const TriangleSoup& soup, std::span<const int> faces, const PlanarFit& fit) {
  if (!fit.upright) return false;
  const double explained = std::min(fit_error(soup, faces), kClearlyBent * fit.extent);
  return fit.deviation <= std::max(explained, kMeantFlat * fit.extent);
}

/// The faces of each polygon of the file, as far as edges connect them.
std::vector<std::vector<int>> faces_of_polygons(const TriangleSoup& soup,
                                                const EdgeGroups& groups) {
  UnionFind polygons(soup.face_count());
  for (int g = 0; g < groups.count(); ++g) {
    const auto edge = groups.group(g);
    if (edge.size() != 2) continue;
    const auto [f, h] = std::pair(edge[0] / 3, edge[1] / 3);
    const bool is_drawn = soup.source_faces[f] != -1;
    if (is_drawn && soup.source_faces[f] == soup.source_faces[h]) polygons.join(f, h);
  }
  std::vector<std::vector<int>> faces(soup.face_count());
  for (int f = 0; f < soup.face_count(); ++f) faces[polygons.find(f)].push_back(f);
  std::erase_if(faces, [](const std::vector<int>& polygon) { return polygon.empty(); });
  return faces;
}

std::vector<Tile> make_tiles(const TriangleSoup& soup, const EdgeGroups& groups) {
  std::vector<Tile> tiles;
  for (std::vector<int>& polygon : faces_of_polygons(soup, groups)) {
    const PlanarFit fit = fit_plane(soup, polygon);
    if (polygon.size() == 1 || is_flat_polygon(soup, polygon, fit)) {
      tiles.push_back({std::move(polygon), fit});
      continue;
    }
    for (const int face : polygon) tiles.push_back({{face}, fit_plane(soup, std::span(&face, 1))});
  }
  return tiles;
}

/// The plane that a group of tiles grows in: that of its first and largest tile.
class GrowingPlane {
 public:
  GrowingPlane(const TriangleSoup& soup, const Tile& seed) : soup_(soup), fit_(seed.fit) {
    const auto area = [&](int f) { return area_vector(soup, f).squaredNorm(); };
    corners_ = soup.faces[*std::max_element(seed.faces.begin(), seed.faces.end(),
                                            [&](int f, int g) { return area(f) < area(g); })];
  }

  /// Whether a tile beside the group lies in the plane whatever the precision. `fold`: angle at the
  /// edge between them.
  bool plainly_holds(const Tile& tile, double fold) const {
    return fold < kPanelAngle && angle_between(fit_.normal, tile.fit.normal) <= kPanelDrift;
  }

  /// Whether it may lie in the plane as far as its tilt tells.
  bool may_hold(const Tile& tile) const {
    const double tilt = angle_between(fit_.normal, tile.fit.normal);
    // Beyond the right angle it would come to lie with its back up.
    return tilt <= kGentleCrease || (tilt <= std::numbers::pi / 3 && is_needle(tile));
  }

  /// How far the corners of a tile are off the plane, in shares of what errors explain.
  double off(const Tile& tile) const {
    double most = 0;
    for (const int face : tile.faces) {
      for (const int v : soup_.faces[face]) most = std::max(most, off(v));
    }
    return most;
  }

 private:
  const TriangleSoup& soup_;
  PlanarFit fit_;
  std::array<int, 3> corners_;

  double off(int vertex) const {
    const Vec3& a = soup_.positions[corners_[0]];
    const Vec3 ab = soup_.positions[corners_[1]] - a;
    const Vec3 ac = soup_.positions[corners_[2]] - a;
    const Vec3 ap = soup_.positions[vertex] - a;
    const Vec3 normal = ab.cross(ac);
    const double area = normal.squaredNorm();
    const double to_b = normal.dot(ap.cross(ac)) / area;  // barycentric coordinates
    const double to_c = normal.dot(ab.cross(ap)) / area;
    const double error =
        soup_.error(vertex) + std::abs(1 - to_b - to_c) * soup_.error(corners_[0]) +
        std::abs(to_b) * soup_.error(corners_[1]) + std::abs(to_c) * soup_.error(corners_[2]);
    const double height = std::abs(fit_.normal.dot(soup_.positions[vertex] - fit_.centre));
    constexpr double kRounding = 1e-15;  // of the height itself, the model being about 1 across
    return height / (kRoot3 * error + fit_.deviation + kRounding);
  }

  /// Whether errors may have turned a triangle by any angle.
  bool is_needle(const Tile& tile) const {
    return tile.faces.size() == 1 &&
           2 * tile.fit.area <= tile.fit.extent * 2 * kRoot3 * largest_error(soup_, tile.faces);
  }
};

/// Tiles beside each tile, and the edge between them as a half-edge of the tile.
struct Neighbour {
  int tile;
  double fold;  ///< angle between the two faces at the edge, without sign
};

std::vector<std::vector<Neighbour>> neighbours_of(const TriangleSoup& soup,
                                                  const EdgeGroups& groups,
                                                  std::span<const Tile> tiles) {
  std::vector<int> tile_of(soup.faces.size());
  for (std::size_t t = 0; t < tiles.size(); ++t) {
    for (const int face : tiles[t].faces) tile_of[face] = static_cast<int>(t);
  }
  std::vector<std::vector<Neighbour>> neighbours(tiles.size());
  for (int g = 0; g < groups.count(); ++g) {
    const auto edge = groups.group(g);
    if (edge.size() != 2) continue;
    const int first = tile_of[edge[0] / 3];
    const int second = tile_of[edge[1] / 3];
    if (first == second) continue;
    const double fold =
        angle_between(area_vector(soup, edge[0] / 3), area_vector(soup, edge[1] / 3));
    neighbours[first].push_back({second, fold});
    neighbours[second].push_back({first, fold});
  }
  return neighbours;
}

/// What kinds of flat edges stand out from the somewhat sharper ones. On a rounded shape creases of
/// all angles occur, and some are slight by chance: those stay creases.
struct Evidence {
  bool of_errors = false;  ///< those that errors explain
  bool of_planes = false;  ///< all flat ones
};

Evidence find_evidence(const TriangleSoup& soup, std::span<const Tile> tiles,
                       std::span<const std::vector<Neighbour>> neighbours) {
  // Spread evenly, creases up to ten times as sharp as errors explain are nine times as many.
  constexpr double kSharper = 10;
  int flat = 0;
  int explained = 0;
  int sharper = 0;
  for (int t = 0; t < static_cast<int>(tiles.size()); ++t) {
    const GrowingPlane plane(soup, tiles[t]);
    for (const auto& [next, fold] : neighbours[t]) {
      const bool is_larger =
          std::pair(tiles[t].fit.area, next) > std::pair(tiles[next].fit.area, t);
      if (!is_larger) continue;
      const double off = plane.off(tiles[next]);
      if (plane.plainly_holds(tiles[next], fold)) {
        ++flat;
      } else if (off <= 1) {
        explained += plane.may_hold(tiles[next]);
      } else {
        sharper += off <= kSharper;
      }
    }
  }
  return {explained > sharper, flat + explained > sharper};
}

/// Tiles of the plane that grows from `seed`; they are taken.
std::vector<int> grow(const TriangleSoup& soup, std::span<const Tile> tiles,
                      std::span<const std::vector<Neighbour>> neighbours, int seed,
                      bool trusts_errors, std::vector<char>& taken) {
  const GrowingPlane plane(soup, tiles[seed]);
  const auto holds = [&](const Tile& tile, double fold) {
    return plane.plainly_holds(tile, fold) ||
           (trusts_errors && plane.may_hold(tile) && plane.off(tile) <= 1);
  };
  std::vector<int> group = {seed};
  taken[seed] = true;
  for (std::size_t head = 0; head < group.size(); ++head) {
    for (const auto& [next, fold] : neighbours[group[head]]) {
      if (taken[next] || !holds(tiles[next], fold)) continue;
      taken[next] = true;
      group.push_back(next);
    }
  }
  return group;
}

}  // namespace

DrawnPlanes find_drawn_planes(const TriangleSoup& soup) {
  const EdgeGroups groups = group_half_edges(soup);
  const std::vector<Tile> tiles = make_tiles(soup, groups);
  const std::vector<std::vector<Neighbour>> neighbours = neighbours_of(soup, groups, tiles);
  const Evidence evidence = find_evidence(soup, tiles, neighbours);
  std::vector<int> by_area(tiles.size());
  std::iota(by_area.begin(), by_area.end(), 0);
  std::stable_sort(by_area.begin(), by_area.end(),
                   [&](int a, int b) { return tiles[a].fit.area > tiles[b].fit.area; });
  std::vector<char> taken(tiles.size(), false);
  DrawnPlanes planes;
  for (const int seed : by_area) {
    if (taken[seed]) continue;
    std::vector<int> faces;
    bool has_polygon = false;
    for (const int tile : grow(soup, tiles, neighbours, seed, evidence.of_errors, taken)) {
      faces.insert(faces.end(), tiles[tile].faces.begin(), tiles[tile].faces.end());
      has_polygon = has_polygon || tiles[tile].faces.size() > 1;
    }
    // Triangles of a rounded shape that happen to lie in one plane were not drawn in it.
    if (faces.size() == 1 || !(has_polygon || evidence.of_planes)) continue;
    std::sort(faces.begin(), faces.end());
    planes.push_back(std::move(faces));
  }
  std::sort(planes.begin(), planes.end());
  return planes;
}

}  // namespace foldwright
