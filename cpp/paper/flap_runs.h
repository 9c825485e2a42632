#pragma once

#include <array>
#include <numbers>
#include <span>
#include <vector>

#include "paper/room_profile.h"
#include "paper/seams.h"

namespace foldwright {

/// Angle of a flap's side at its base where another flap of its run follows: two such sides leave a
/// notch of 20 degrees between them, about as narrow as scissors cut in two strokes.
inline constexpr double kNotchAngle = 80 * std::numbers::pi / 180;

/// On longer bases than so many heights a flap holds by itself, and looks like any other.
inline constexpr double kLongestInRun = 4;

/// Longer bases than so many heights have no single tooth, which would hold them in the middle
/// only.
inline constexpr double kWidestTooth = 2.5;

/// Of a seam: by side and end whether a run goes on there.
using RunEnds = std::array<std::array<bool, 2>, 2>;

/// Per seam where runs go on: at the ends at which its chain does (`seam_chains`) and the outline
/// of that side bends by at most 45 degrees.
std::vector<RunEnds> find_runs(std::span<const Seam> seams);

/// A flap over the same base whose sides meet above its middle.
Trapezoid tooth_of(const Trapezoid& flap);

}  // namespace foldwright
