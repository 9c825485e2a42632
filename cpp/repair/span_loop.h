#pragma once

#include <array>
#include <functional>
#include <span>
#include <vector>

#include "geometry/vec.h"

namespace foldwright {

/// What the triangles that span a loop must not be.
struct SpanLimits {
  /// No triangle is lower than this (a length) over its longest side.
  double least_height = 0;
  /// Whether corners i < j must not be connected across the loop.
  std::function<bool(int, int)> is_taken = [](int, int) { return false; };
};

/// Spans a closed loop in space with n - 2 triangles of its winding, of the least area: flat where
/// the loop is. Of equally flat ways it takes the one with the shorter connections, so that
/// triangles are well shaped.
///
/// If that can be, no triangle is seen from behind along the loop's Newell normal: then none runs
/// through another one. Corners count from 0. Empty if the limits leave no way. By dynamic
/// programming (Barequet and Sharir, "Filling Gaps in the Boundary of a Polyhedron", 1995, section
/// 4), in cubic time; loops of more than 150 corners, which would take long, are cut ear by ear.
/// \pre at least 3 corners
std::vector<std::array<int, 3>> span_loop(std::span<const Vec3> loop, const SpanLimits& limits);

}  // namespace foldwright
