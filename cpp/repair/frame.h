#pragma once

#include <cmath>
#include <span>

#include "geometry/vec.h"

namespace foldwright {

/// The model's own units and the repair's, in which it is about 1 across: squares of areas would
/// leave the range of doubles at 1e-30 or 1e30. Powers of two, so that nothing is rounded.
struct Frame {
  Vec3 centre;
  int exponent;
  double diagonal;  // of the bounding box, in the repair's units
  double longest;   // side of the box, in the repair's units

  double scaled(double length) const { return std::ldexp(length, -exponent); }
  double in_model_units(double length) const { return std::ldexp(length, exponent); }
  Vec3 in_model_units(const Vec3& p) const {
    return p.unaryExpr([&](double x) { return std::ldexp(x, exponent); });
  }
  Vec3 scaled(const Vec3& p) const {
    return (p - centre).unaryExpr([&](double x) { return std::ldexp(x, -exponent); });
  }
};

/// The frame of these positions. \throw InputError when they lie at one place, or a size is out of
/// range
Frame frame_of(std::span<const Vec3> positions);

}  // namespace foldwright
