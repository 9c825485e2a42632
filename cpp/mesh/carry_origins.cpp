#include "mesh/carry_origins.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "mesh/surface_tree.h"

namespace foldwright {
namespace {

// A corner's side of the surface is looked for so far from it towards the middle of its face: far
// enough for rounding, near enough to be among the faces at the corner.
constexpr double kInwards = 0.25;

// Weight of the normals against squared distances from there, as shares of that way: enough to tell
// the sides of a thin sheet apart, and no more, since the nearest face is mostly the right one.
constexpr double kNormalWeight = 0.1;

// Faces that are further by less than this share of the way are as near: rounding.
constexpr double kAsNear = 1e-6;

/// The face of the surface whose point is the nearest to a corner, on the side of its own face.
int face_below(const SurfaceTree& surface, const Triangle3& own, int corner, int guess) {
  const Vec3& point = own[corner];
  const Vec3 way = kInwards * ((own[0] + own[1] + own[2]) / 3 - point);
  const Vec3 normal = normal_of(own);
  const auto cost = [&](int face) {
    return surface.squared_distance(face, point + way) / way.squaredNorm() +
           kNormalWeight * (1 - normal.dot(surface.normal(face)));
  };
  const int nearest = surface.nearest(point, guess);
  const double reach = std::sqrt(surface.squared_distance(nearest, point)) + kAsNear * way.norm();
  int best = nearest;
  double least = cost(nearest);
  surface.visit_near(point, reach * reach, [&](int face) {
    if (surface.squared_distance(face, point) > reach * reach) return reach * reach;
    const double value = cost(face);
    if (value < least || (value == least && face < best)) least = value, best = face;
    return reach * reach;
  });
  return best;
}

/// One-sided: of the vertices of one mesh from the surface of the other.
double furthest_vertex(const Mesh& from, const Mesh& to) {
  const SurfaceTree surface(to);
  double furthest = 0;
  int nearest = 0;
  for (const Vec3& position : from.positions) {
    nearest = surface.nearest(position, nearest);
    furthest = std::max(furthest, surface.squared_distance(nearest, position));
  }
  return std::sqrt(furthest);
}

}  // namespace

std::vector<FaceOrigins> carry_origins(const Mesh& from, std::span<const FaceOrigins> origins,
                                       const Mesh& to) {
  assert(from.face_count() > 0 && origins.size() == from.faces.size());
  const SurfaceTree surface(from);
  std::vector<FaceOrigins> carried;
  int face = 0;
  for (int f = 0; f < to.face_count(); ++f) {
    const Triangle3 own = corners_of(to, f);
    FaceOrigins& places = carried.emplace_back();
    for (int i = 0; i < 3; ++i) {
      face = face_below(surface, own, i, face);
      const Triangle3& below = surface.corners(face);
      places[i] = place_within(origins[face], barycentric(below, closest_point(below, own[i])));
    }
  }
  return carried;
}

double largest_deviation(const Mesh& a, const Mesh& b) {
  return std::max(furthest_vertex(a, b), furthest_vertex(b, a));
}

}  // namespace foldwright
