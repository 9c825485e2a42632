#pragma once

#include <span>
#include <vector>

#include "geometry/vec.h"

namespace foldwright {

/// Finds the points near a segment: a k-d tree over a fixed set of points.
///
/// Built in O(n log n); a query takes about O(log n) plus what it finds and passes by. Refers to
/// the points, which must outlive it.
class SegmentQuery {
 public:
  explicit SegmentQuery(std::span<const Vec3> points);

  /// Indices of the points at most `distance` away from the segment from a to b, ascending.
  std::vector<int> near(const Vec3& a, const Vec3& b, double distance) const;

 private:
  using Box = Eigen::AlignedBox3d;

  std::span<const Vec3> points_;
  std::vector<int> order_;  // indices of points; a node has a range of it, its children the halves
  std::vector<Box> boxes_;  // per node; the root is 1, the children of i are 2 i and 2 i + 1

  void build(int node, int begin, int end);
};

}  // namespace foldwright
