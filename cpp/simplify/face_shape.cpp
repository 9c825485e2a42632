#include "simplify/face_shape.h"

#include <algorithm>
#include <cmath>

namespace foldwright {
namespace {

// A triangle is thin when its altitude is less than this share of its longest edge: an isosceles
// one with angles of 35 degrees has as much.
constexpr double kThin = 0.35;

// A triangle is low when its altitude is less than this share of a usual edge.
constexpr double kLow = 0.2;

// The thinnest triangle costs as much as a fan of its size that is off the surface by a
// thirty-fifth of its size, the lowest one as much as one that is off by a ninetieth.
constexpr double kThinWeight = 2e-3;
constexpr double kLowWeight = 3e-4;

// Longer edges count like those of so many usual ones: what is long in the model must stay so.
constexpr double kLongest = 2;

// A collapse may turn a face's normal by as much as has this cosine.
constexpr double kLeastTurn = 0.35;

// A face whose altitude is a smaller share of its longest edge has no normal to speak of.
constexpr double kFlattest = 1e-3;

double square(double x) { return x * x; }

Vec3 doubled_area(const Triangle3& t) { return (t[1] - t[0]).cross(t[2] - t[0]); }

/// Square of the length of the longest edge.
double longest_edge2(const Triangle3& t) {
  return std::max(
      {(t[1] - t[0]).squaredNorm(), (t[2] - t[1]).squaredNorm(), (t[0] - t[2]).squaredNorm()});
}

}  // namespace

double shape_cost(const Triangle3& t, double usual) {
  const double longest2 = longest_edge2(t);
  if (longest2 == 0) return kThinWeight * square(square(usual));
  const double area2 = doubled_area(t).norm();
  const double thinness = std::max(0.0, 1 - area2 / longest2 / kThin);
  const double altitude = area2 / std::sqrt(longest2);
  const double lowness = std::max(0.0, 1 - altitude / (kLow * usual));
  const double size2 = std::min(longest2, square(kLongest * usual));
  return kThinWeight * square(size2 * thinness) + kLowWeight * square(usual * usual * lowness);
}

bool keeps_facing(const Triangle3& before, const Triangle3& after) {
  const Vec3 now = doubled_area(after);
  if (now.norm() < kFlattest * longest_edge2(after)) return false;
  const Vec3 then = doubled_area(before);
  return then.dot(now) >= kLeastTurn * then.norm() * now.norm();
}

}  // namespace foldwright
