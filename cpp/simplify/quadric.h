#pragma once

#include "geometry/vec.h"

namespace foldwright {

/// Weighted squared distances of a point from planes, summed up.
/// Source: Garland, Heckbert, "Surface Simplification Using Quadric Error Metrics" (1997).
class Quadric {
 public:
  /// Adds the plane through a point. `normal`: of unit length.
  void add_plane(const Vec3& normal, const Vec3& point, double weight);

  Quadric& operator+=(const Quadric& other);

  /// The sum at a point; never negative.
  double at(const Vec3& p) const;

  /// The nearest point to `start` where the sum is least, as far as the planes determine one: along
  /// directions in which the sum hardly grows, as along a crease or within a flat region, the point
  /// stays at `start`'s height. `across`, if not null: normal of a plane that `start` is moved
  /// within alone.
  Vec3 least_near(const Vec3& start, const Vec3* across = nullptr) const;

 private:
  // p.A.p + 2 b.p + c, A by its upper triangle.
  double xx_ = 0, xy_ = 0, xz_ = 0, yy_ = 0, yz_ = 0, zz_ = 0;
  Vec3 b_ = Vec3::Zero();
  double c_ = 0;
};

}  // namespace foldwright
