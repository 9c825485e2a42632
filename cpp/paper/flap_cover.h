#pragma once

#include <array>
#include <utility>
#include <vector>

#include "geometry/vec.h"

namespace foldwright {

/// What hides a flap: the flat panel beyond its base, which the flap must not leave. In the
/// coordinates of the base, which the panel lies above; mm.
struct FlapCover {
  /// How far the borders of the panel at the two ends of the base come in per height; negative
  /// where they go out.
  std::array<double, 2> lean = {0, 0};
  std::vector<std::array<Vec2, 2>> borders = {};  ///< all others that lie over the base
};

/// A panel over a base of this length, from its borders one by one.
class CoverBuilder {
 public:
  explicit CoverBuilder(double length) : length_(length) {}

  /// The border that starts from an end of the base, up to `tip`.
  void add_at_end(int end, const Vec2& tip);
  /// Any other border; what does not lie over the base is left out.
  void add(const Vec2& from, const Vec2& to);

  FlapCover take() { return std::move(cover_); }

 private:
  double length_;
  FlapCover cover_;
};

/// A cover seen along its base of this length the other way.
FlapCover seen_back(FlapCover cover, double length);

/// How high a cover is over a point of its base.
double height_at(const FlapCover& cover, double length, double x);

}  // namespace foldwright
