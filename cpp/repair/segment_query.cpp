#include "repair/segment_query.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <utility>

namespace foldwright {
namespace {

constexpr int kLeafSize = 8;  // a handful of distances costs less than another level of boxes

double squared_distance(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 along = b - a;
  const double length = along.squaredNorm();
  const double t = length > 0 ? std::clamp(along.dot(p - a) / length, 0.0, 1.0) : 0;
  return (a + t * along - p).squaredNorm();
}

/// Whether the segment comes into the box, widened by `margin`: clipped by one slab after another.
bool meets(const Eigen::AlignedBox3d& box, const Vec3& a, const Vec3& b, double margin) {
  double enter = 0;
  double leave = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const double low = box.min()[axis] - margin - a[axis];
    const double high = box.max()[axis] + margin - a[axis];
    const double along = b[axis] - a[axis];
    if (along == 0) {
      if (low > 0 || high < 0) return false;
      continue;
    }
    const auto [near, far] = std::minmax({low / along, high / along});
    enter = std::max(enter, near);
    leave = std::min(leave, far);
  }
  return enter <= leave;
}

}  // namespace

SegmentQuery::SegmentQuery(std::span<const Vec3> points)
    : points_(points), order_(points.size()), boxes_(4 * std::bit_ceil(points.size() + 1)) {
  std::iota(order_.begin(), order_.end(), 0);
  build(1, 0, static_cast<int>(order_.size()));
}

void SegmentQuery::build(int node, int begin, int end) {
  for (int i = begin; i < end; ++i) boxes_[node].extend(points_[order_[i]]);
  if (end - begin <= kLeafSize) return;
  int axis = 0;
  boxes_[node].sizes().maxCoeff(&axis);
  const int middle = (begin + end) / 2;
  std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                   [&](int i, int j) {
                     return std::pair(points_[i][axis], i) < std::pair(points_[j][axis], j);
                   });
  build(2 * node, begin, middle);
  build(2 * node + 1, middle, end);
}

std::vector<int> SegmentQuery::near(const Vec3& a, const Vec3& b, double distance) const {
  struct Range {
    int node, begin, end;
  };
  // Boxes are tested with some room to spare for rounding; the points themselves decide.
  const double margin = 2 * distance;
  std::vector<int> found;
  std::vector<Range> stack = {{1, 0, static_cast<int>(order_.size())}};
  while (!stack.empty()) {
    const auto [node, begin, end] = stack.back();
    stack.pop_back();
    if (begin == end || !meets(boxes_[node], a, b, margin)) continue;
    if (end - begin > kLeafSize) {
      const int middle = (begin + end) / 2;
      stack.push_back({2 * node, begin, middle});
      stack.push_back({2 * node + 1, middle, end});
      continue;
    }
    for (int i = begin; i < end; ++i) {
      if (squared_distance(points_[order_[i]], a, b) <= distance * distance) {
        found.push_back(order_[i]);
      }
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace foldwright
