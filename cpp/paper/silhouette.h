#pragma once

#include <array>

#include "geometry/vec.h"
#include "paper/turns.h"

namespace foldwright {

/// How far points reach in 32 directions: a polygon around their convex hull that is cheap to keep,
/// at most 2 % larger in area than the hull of a compact shape.
class Silhouette {
 public:
  Silhouette();

  void clear();
  void add(const Vec2& point);

  /// Area of the polygon; 0 of no points.
  double area() const;
  /// By how much the points stick out of a room in the best of the turns, width and height added;
  /// 0 where they fit.
  double excess(const Extent& room) const;

 private:
  static constexpr int kAxes = 16;  // a direction and its opposite each
  double reach(int direction) const;

  std::array<float, kAxes> low_, high_;
};

}  // namespace foldwright
