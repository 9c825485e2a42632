#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "face_crossings.h"
#include "mesh/carry_origins.h"
#include "mesh/surface_tree.h"
#include "meshes.h"

namespace foldwright::testing {

/// What a simplified mesh is worth to whoever folds it.
struct Simplified {
  int faces;
  double deviation;       ///< the largest, percent of the diagonal
  double mean_deviation;  ///< of the original vertices, percent of the diagonal
  double worst_angle;     ///< degrees
  double thin;            ///< percent of faces with an angle of less than 15 degrees
  double low;             ///< percent of faces with an altitude below 15 % of the usual edge
  int crossings;          ///< pairs of faces without a common vertex that run through each other
};

inline double diagonal_of(const Mesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Vec3& p : mesh.positions) box.extend(p);
  return box.diagonal().norm();
}

inline Simplified measured(const Mesh& original, const Mesh& simple) {
  Simplified result{};
  const double diagonal = diagonal_of(original);
  result.faces = simple.face_count();
  result.deviation = 100 * largest_deviation(original, simple) / diagonal;
  const SurfaceTree surface(simple);
  int nearest = 0;
  for (const Vec3& p : original.positions) {
    nearest = surface.nearest(p, nearest);
    result.mean_deviation += std::sqrt(surface.squared_distance(nearest, p));
  }
  result.mean_deviation *= 100 / diagonal / original.vertex_count();
  const double usual = std::sqrt(4 * area_of(simple) / (std::sqrt(3) * simple.face_count()));
  result.worst_angle = 180;
  for (int f = 0; f < simple.face_count(); ++f) {
    const Triangle3 t = corners_of(simple, f);
    const double least = sharpest_corner(t);
    const double longest =
        std::max({(t[1] - t[0]).norm(), (t[2] - t[1]).norm(), (t[0] - t[2]).norm()});
    result.worst_angle = std::min(result.worst_angle, least);
    result.thin += 100.0 * (least < 15) / simple.face_count();
    result.low += 100.0 * (2 * face_area(simple, f) / longest < 0.15 * usual) / simple.face_count();
  }
  result.crossings = crossing_count(simple);
  return result;
}

}  // namespace foldwright::testing
