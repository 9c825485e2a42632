#pragma once

#include <array>

#include "geometry/box.h"
#include "geometry/rigid_motion3.h"
#include "geometry/triangle2.h"

namespace foldwright {

/// Triangle in space.
using Triangle3 = std::array<Vec3, 3>;

Box3 box_of(const Triangle3& t);

/// The triangle of the plane z = 0 moved to its place in space.
Triangle3 moved(const RigidMotion3& motion, const Triangle2& t);
Triangle3 moved(const RigidMotion3& motion, const Triangle3& t);

/// The point of a triangle that is nearest to `p`.
Vec3 closest_point(const Triangle3& t, const Vec3& p);

/// Shares of the corners in a point of a triangle's plane; they add up to 1. \pre it has an area
Vec3 barycentric(const Triangle3& t, const Vec3& p);

/// Each side moved inwards by `depth`: scaled about the incentre by 1 - depth / r, r the inradius,
/// but by no less than `least`.
Triangle2 eroded(const Triangle2& t, double depth, double least);

/// Whether two triangles have a point in common, or no direction in which they are apart by more
/// than `tolerance` (a length).
///
/// Separating axes: the line between the centroids, the normals of both planes, the cross products
/// of their edges, and for triangles in one plane the normals of their edges in it. Exact up to
/// rounding, which decides over triangles in one plane if the tolerance is 0.
bool triangles_meet(const Triangle3& a, const Triangle3& b, double tolerance);

/// Whether two triangles run through each other: along no direction that could tell them apart do
/// they reach into each other by less than `depth` (a length). Triangles in one plane do not.
bool triangles_cross(const Triangle3& a, const Triangle3& b, double depth);

/// Calls `visit(axis)` for directions along which disjoint triangles are apart, likely ones first,
/// until it returns true. Axes are not normalised and may vanish.
template <class Visit>
void for_separating_axes(const Triangle3& a, const Triangle3& b, Visit&& visit) {
  // Not needed to tell them apart, but most that are not close are apart along it.
  if (visit(Vec3(b[0] + b[1] + b[2] - (a[0] + a[1] + a[2])))) return;
  const std::array<Vec3, 3> edges_a = {a[1] - a[0], a[2] - a[1], a[0] - a[2]};
  const std::array<Vec3, 3> edges_b = {b[1] - b[0], b[2] - b[1], b[0] - b[2]};
  const Vec3 normal_a = edges_a[0].cross(edges_a[1]);
  const Vec3 normal_b = edges_b[0].cross(edges_b[1]);
  if (visit(normal_a) || visit(normal_b)) return;
  for (int i = 0; i < 3; ++i) {
    if (visit(edges_a[i].cross(normal_a)) || visit(edges_b[i].cross(normal_b))) return;
  }
  for (const Vec3& edge_a : edges_a) {
    for (const Vec3& edge_b : edges_b) {
      if (visit(edge_a.cross(edge_b))) return;
    }
  }
}

}  // namespace foldwright
