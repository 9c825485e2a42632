#include "repair/triangulate.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace foldwright {
namespace {

using Triangle = std::array<int, 3>;

/// Unit normal of a triangle; zero when it is degenerate or nearly so.
Vec3 unit_normal(std::span<const Vec3> p, const Triangle& triangle) {
  // A triangle this thin compared with its longest side is worth a longer diagonal or a bend.
  constexpr double kThin = 1e-4;
  const auto& [a, b, c] = triangle;
  const double longest = std::max(
      {(p[b] - p[a]).squaredNorm(), (p[c] - p[b]).squaredNorm(), (p[a] - p[c]).squaredNorm()});
  const Vec3 normal = (p[b] - p[a]).cross(p[c] - p[a]);
  const double length = normal.norm();
  return length <= kThin * longest ? Vec3::Zero() : Vec3(normal / length);
}

/// Cosine of the angle between the normals of two triangles; -2 when one is degenerate.
double flatness(std::span<const Vec3> p, const std::vector<Triangle>& pair) {
  const Vec3 normal_0 = unit_normal(p, pair[0]);
  const Vec3 normal_1 = unit_normal(p, pair[1]);
  return normal_0.isZero(0) || normal_1.isZero(0) ? -2 : normal_0.dot(normal_1);
}

std::vector<Triangle> triangulate_quad(std::span<const Vec3> p) {
  // Bends that differ by less are rounding: a tenth of a degree in a nearly planar quad.
  constexpr double kSameBend = 1e-6;
  constexpr double kSameLength = 1e-9;
  const std::vector<Triangle> from_0 = {{0, 1, 2}, {0, 2, 3}};
  const std::vector<Triangle> from_1 = {{1, 2, 3}, {1, 3, 0}};
  const double flatter = flatness(p, from_0) - flatness(p, from_1);
  if (std::abs(flatter) > kSameBend) return flatter > 0 ? from_0 : from_1;
  const double length_0 = (p[2] - p[0]).norm();
  const double length_1 = (p[3] - p[1]).norm();
  return length_1 < length_0 * (1 - kSameLength) ? from_1 : from_0;
}

/// The polygon seen along its Newell normal, so that it is mostly counter-clockwise.
std::vector<Vec2> project(std::span<const Vec3> polygon) {
  Vec3 normal = Vec3::Zero();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3& next = polygon[(i + 1) % polygon.size()];
    normal += (polygon[i] - polygon[0]).cross(next - polygon[0]);
  }
  if (normal.isZero(0)) normal = Vec3::UnitZ();
  const Vec3 x = normal.unitOrthogonal();
  const Vec3 y = normal.normalized().cross(x);
  std::vector<Vec2> points;
  for (const Vec3& p : polygon) points.emplace_back(x.dot(p - polygon[0]), y.dot(p - polygon[0]));
  return points;
}

class EarClipper {
 public:
  explicit EarClipper(std::vector<Vec2> points)
      : points_(std::move(points)), left_(static_cast<int>(points_.size())) {
    double extent = 0;
    for (int i = 0; i < left_; ++i) {
      previous_.push_back((i + left_ - 1) % left_);
      next_.push_back((i + 1) % left_);
      extent = std::max(extent, points_[i].squaredNorm());
    }
    on_border_ = -kRounding * extent;
    scores_.resize(points_.size());
    score_all(0);
  }

  std::vector<Triangle> clip() {
    std::vector<Triangle> triangles;
    int start = 0;
    while (left_ > 3) {
      int ear = best_ear(start);
      if (scores_[ear] < 0 && tests_left_ > 0) {  // clipping may have opened others since
        score_all(start);
        ear = best_ear(start);
      }
      if (scores_[ear] < 0) ear = flattest(start);
      triangles.push_back({previous_[ear], ear, next_[ear]});
      start = previous_[ear];
      remove(ear);
    }
    triangles.push_back({previous_[start], start, next_[start]});
    return triangles;
  }

 private:
  // Sines of angles, and areas relative to the polygon's, below these are rounding.
  static constexpr double kSmallestSine = 1e-9;
  static constexpr double kRounding = 1e-12;
  static constexpr double kNoEar = -1;

  std::vector<Vec2> points_;
  int left_;
  std::vector<int> previous_;
  std::vector<int> next_;
  std::vector<double> scores_;  // how well shaped the ear at a corner is; negative: no ear
  double on_border_;
  // About a second; beyond, only clipped corners are looked at anew.
  long long tests_left_ = 300'000'000;

  Vec2 incoming(int i) const { return points_[i] - points_[previous_[i]]; }
  Vec2 outgoing(int i) const { return points_[next_[i]] - points_[i]; }

  bool is_convex(int i) const {
    const Vec2 in = incoming(i);
    const Vec2 out = outgoing(i);
    return cross(in, out) > kSmallestSine * in.norm() * out.norm();
  }

  /// Whether a corner that is not convex lies in the ear or on its border. Convex ones do not
  /// matter: they cannot be the only ones inside. Corners at the same place as the ear's own
  /// (bridges to holes) do not block it.
  bool is_blocked(int ear) {
    const Vec2& a = points_[previous_[ear]];
    const Vec2& b = points_[ear];
    const Vec2& c = points_[next_[ear]];
    for (int i = next_[next_[ear]]; i != previous_[ear]; i = next_[i]) {
      --tests_left_;
      const Vec2& p = points_[i];
      if (cross(b - a, p - a) < on_border_ || cross(c - b, p - b) < on_border_ ||
          cross(a - c, p - c) < on_border_) {
        continue;
      }
      if (p != a && p != b && p != c && !is_convex(i)) return true;
    }
    return false;
  }

  double score(int i) {
    if (!is_convex(i) || is_blocked(i)) return kNoEar;
    const Vec2 in = incoming(i);
    const Vec2 out = outgoing(i);
    // Area over squared sides: largest for the equilateral triangle, 0 for slivers.
    return cross(in, out) / (in.squaredNorm() + out.squaredNorm() + (in + out).squaredNorm());
  }

  void score_all(int start) {
    int i = start;
    for (int n = 0; n < left_; ++n, i = next_[i]) scores_[i] = score(i);
  }

  /// The ring is walked from `start`; of equals the lowest corner wins, wherever the walk begins.
  int best_ear(int start) const {
    int best = start;
    int i = start;
    for (int n = 0; n < left_; ++n, i = next_[i]) {
      if (scores_[i] > scores_[best] || (scores_[i] == scores_[best] && i < best)) best = i;
    }
    return best;
  }

  int flattest(int start) const {
    const auto size = [&](int i) { return std::abs(cross(incoming(i), outgoing(i))); };
    int best = start;
    int i = start;
    for (int n = 0; n < left_; ++n, i = next_[i]) {
      if (size(i) < size(best) || (size(i) == size(best) && i < best)) best = i;
    }
    return best;
  }

  void remove(int i) {
    const int before = previous_[i];
    const int after = next_[i];
    next_[before] = after;
    previous_[after] = before;
    --left_;
    scores_[before] = score(before);
    scores_[after] = score(after);
  }
};

/// Height of a triangle over its longest edge, in lengths of that; negative if it is clockwise.
double slenderness(std::span<const Vec2> points, const Triangle& t) {
  double longest = 0;
  for (int i = 0; i < 3; ++i) {
    longest = std::max(longest, (points[t[(i + 1) % 3]] - points[t[i]]).squaredNorm());
  }
  return longest > 0 ? cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]) / longest
                     : 0;
}

/// The triangle turned so that its longest edge comes first.
Triangle from_longest_edge(std::span<const Vec2> points, Triangle t) {
  const auto length = [&](int i) { return (points[t[(i + 1) % 3]] - points[t[i]]).squaredNorm(); };
  int longest = 0;
  for (const int i : {1, 2}) {
    if (length(i) > length(longest)) longest = i;
  }
  std::rotate(t.begin(), t.begin() + longest, t.end());
  return t;
}

/// Clipping ears leaves needles between corners in line, whose rounding may even turn them over:
/// they give their longest edge for the other diagonal of the two triangles beside it, where that
/// leaves the slenderer of the two broader.
class NeedleFlipper {
 public:
  NeedleFlipper(std::span<const Vec2> points, std::vector<Triangle>& triangles)
      : points_(points), triangles_(triangles) {
    for (int t = 0; t < static_cast<int>(triangles.size()); ++t) put(t, triangles[t]);
  }

  void flip_all() {
    // Each flip makes triangles broader, but there may be many on the way.
    auto flips_left = triangles_.size();
    while (!needles_.empty() && flips_left > 0) {
      const int needle = needles_.back();
      needles_.pop_back();
      flips_left -= flip(needle);
    }
  }

 private:
  static constexpr double kNeedle = 0.02;

  std::span<const Vec2> points_;
  std::vector<Triangle>& triangles_;
  std::map<std::pair<int, int>, int> beside_;  // the triangle along an edge, by its ends
  std::vector<int> needles_;

  void put(int index, const Triangle& triangle) {
    triangles_[index] = triangle;
    for (int i = 0; i < 3; ++i) beside_[{triangle[i], triangle[(i + 1) % 3]}] = index;
    if (slenderness(points_, triangle) < kNeedle) needles_.push_back(index);
  }

  bool flip(int needle) {
    const auto [a, b, c] = from_longest_edge(points_, triangles_[needle]);
    const auto entry = beside_.find({b, a});
    if (entry == beside_.end()) return false;  // the edge is one of the polygon's
    const int other = entry->second;
    const Triangle& t = triangles_[other];
    const int d = t[0] != a && t[0] != b ? t[0] : t[1] != a && t[1] != b ? t[1] : t[2];
    const Triangle first = {c, a, d};
    const Triangle second = {d, b, c};
    const double before =
        std::min(slenderness(points_, triangles_[needle]), slenderness(points_, triangles_[other]));
    const double after = std::min(slenderness(points_, first), slenderness(points_, second));
    if (after <= before) return false;
    beside_.erase({a, b});
    beside_.erase({b, a});
    put(needle, first);
    put(other, second);
    return true;
  }
};

}  // namespace

std::vector<Triangle> triangulate(std::span<const Vec3> polygon) {
  if (polygon.size() == 3) return {{0, 1, 2}};
  if (polygon.size() == 4) return triangulate_quad(polygon);
  const std::vector<Vec2> points = project(polygon);
  std::vector<Triangle> triangles = EarClipper(points).clip();
  NeedleFlipper(points, triangles).flip_all();
  return triangles;
}

}  // namespace foldwright
