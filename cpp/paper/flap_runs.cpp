#include "paper/flap_runs.h"

#include <algorithm>
#include <cmath>

namespace foldwright {
namespace {

// Flaps at a sharper bend point away from each other: a strip of them does not lie together.
constexpr double kGentle = 45 * std::numbers::pi / 180;

// Of a tooth's top, mm: a point that scissors can turn at.
constexpr double kPoint = 0.3;

bool bends_gently(const SeamSide& before, const SeamSide& after) {
  const Vec2 a = before.to - before.from;
  const Vec2 b = after.to - after.from;
  return std::abs(std::atan2(cross(a, b), a.dot(b))) <= kGentle;
}

}  // namespace

std::vector<RunEnds> find_runs(std::span<const Seam> seams) {
  std::vector<RunEnds> runs(seams.size(), RunEnds{});
  const auto join = [&](const SeamStep& before, const SeamStep& after) {
    if (!bends_gently(seams[before.seam].sides[before.side], seams[after.seam].sides[after.side])) {
      return;
    }
    runs[before.seam][before.side][1] = true;
    runs[after.seam][after.side][0] = true;
  };
  const auto across = [](const SeamStep& step) { return SeamStep{step.seam, 1 - step.side}; };
  for (const auto& chain : seam_chains(seams)) {
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
      join(chain[i], chain[i + 1]);
      // On the other bank the chain runs the other way.
      join(across(chain[i + 1]), across(chain[i]));
    }
  }
  return runs;
}

Trapezoid tooth_of(const Trapezoid& flap) {
  const double middle = 0.5 * (flap.top[0] + flap.top[1]);
  const double half = std::min(0.5 * kPoint, 0.5 * (flap.top[1] - flap.top[0]));
  return {flap.height, {flap.foot[0], flap.foot[1]}, {middle - half, middle + half}};
}

}  // namespace foldwright
