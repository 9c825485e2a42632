#include "paper/flap_gaps.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/convex2.h"

namespace foldwright {
namespace {

constexpr double kLook = 0.4;      // from one look ahead to the next, mm
constexpr double kDrawStep = 0.2;  // by which sides are drawn in

// Millimetres of cuts side by side that a millimetre of a flap's width is worth: without a price
// flaps would shrink next to slits that stay close whatever they do.
constexpr double kPrice = 1;

// Two cuts that leave a common corner are close for less than that.
constexpr double kSideBySide = 3;

constexpr double kUpon = 0.3;  // mm; a side so near to a line is laid on it
constexpr double kRounding = 1e-7;

struct Line {
  Vec2 from, to;  ///< paper on the left
};

/// A line with the distance that should be kept from it.
struct Neighbour {
  Line line;
  double apart;
};

/// The distance from `p` along `ahead` to the front of a line; infinite if they do not meet.
double distance_to(const Line& line, const Vec2& p, const Vec2& ahead) {
  const Vec2 along = line.to - line.from;
  const double across = cross(ahead, along);
  if (across >= 0) return HUGE_VAL;
  const Vec2 way = line.from - p;
  const double at = cross(way, ahead) / across;
  return at < 0 || at > 1 ? HUGE_VAL : cross(way, along) / across;
}

/// How much of a line has a neighbour too near, straight ahead.
double close_length(const Line& line, std::span<const Neighbour> neighbours) {
  const Vec2 along = line.to - line.from;
  const double length = along.norm();
  if (length == 0) return 0;
  const Vec2 ahead = Vec2(along.y(), -along.x()) / length;
  const int looks = static_cast<int>(std::ceil(length / kLook));
  int close = 0;
  for (int i = 0; i < looks; ++i) {
    const Vec2 p = line.from + (i + 0.5) / looks * along;
    close += std::ranges::any_of(neighbours, [&](const Neighbour& near) {
      const double distance = distance_to(near.line, p, ahead);
      return distance > -kDrawStep && distance < near.apart;
    });
  }
  return close * length / looks;
}

std::vector<Neighbour> lines_near(const FlapNeighbours& neighbours, const Box2& around) {
  std::vector<Neighbour> found;
  const auto add = [&](const std::vector<std::span<const Vec2>>& polygons, double apart) {
    for (const std::span<const Vec2> polygon : polygons) {
      for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Line line = {polygon[i], polygon[(i + 1) % polygon.size()]};
        if (box_of(std::array{line.from, line.to}).grown(1e-9).meets(around)) {
          found.push_back({line, apart});
        }
      }
    }
  };
  add(neighbours.faces, kApart);
  add(neighbours.flaps, kApart / 2);
  return found;
}

double width_of_top(const Trapezoid& flap) { return flap.top[1] - flap.top[0]; }

/// Whether the foot at one end of a flap is on its base, up to rounding.
bool is_on_base(const Trapezoid& flap, int end, double length) {
  return flap.foot[end] > -kRounding && flap.foot[end] < length + kRounding;
}

/// What is cut at one end of a flap: the edge up to its foot, then its side.
std::array<Line, 2> lines_at(const SeamSide& side, const Trapezoid& flap, int end) {
  const Vec2 foot = side.global({flap.foot[end], 0});
  const Vec2 top = side.global({flap.top[end], flap.height});
  if (end == 0) return {{{side.from, foot}, {foot, top}}};
  return {{{top, foot}, {foot, side.to}}};
}

}  // namespace

std::optional<Trapezoid> laid_on(const SeamSide& side, const Trapezoid& flap, int end,
                                 const FlapNeighbours& neighbours) {
  const Vec2 foot = side.global({flap.foot[end], 0});
  const Vec2 top = side.global({flap.top[end], flap.height});
  const Vec2 along = end == 0 ? Vec2(top - foot) : Vec2(foot - top);
  std::optional<Trapezoid> best;
  double least = kUpon;
  for (const auto& [line, apart] :
       lines_near(neighbours, box_of(std::array{foot, top}).grown(kUpon))) {
    const Vec2 from = side.local(line.from);
    const Vec2 way = side.local(line.to) - from;
    // The line must face the flap, and be neither beside nor beyond its side.
    if ((line.to - line.from).dot(along) >= 0 || std::abs(way.y()) < 1e-9) continue;
    Trapezoid laid = flap;
    laid.foot[end] = from.x() - from.y() / way.y() * way.x();
    laid.top[end] = from.x() + (flap.height - from.y()) / way.y() * way.x();
    const double off = std::max(std::abs(laid.foot[end] - flap.foot[end]),
                                std::abs(laid.top[end] - flap.top[end]));
    if (off >= least || !is_on_base(laid, end, side.length())) continue;
    laid.foot[end] = std::clamp(laid.foot[end], 0.0, side.length());
    if (2 * width_of_top(laid) < width_of_top(flap)) continue;
    least = off;
    best = laid;
  }
  return best;
}

Trapezoid drawn_in(const SeamSide& side, const Trapezoid& flap, int end,
                   const FlapNeighbours& neighbours) {
  Trapezoid best = flap;
  const double most = width_of_top(flap) / 3;
  if (most < kDrawStep) return flap;
  const auto own = lines_at(side, flap, end);
  const std::array<Vec2, 4> points = {own[0].from, own[0].to, own[1].from, own[1].to};
  const std::vector<Neighbour> near = lines_near(neighbours, box_of(points).grown(kApart));
  const auto close_at = [&](const Trapezoid& trial) {
    const auto [first, second] = lines_at(side, trial, end);
    return close_length(first, near) + close_length(second, near);
  };
  double least = close_at(flap);
  if (least < kSideBySide) return flap;
  for (double by = kDrawStep; by <= most && least > kPrice * by; by += kDrawStep) {
    Trapezoid trial = flap;
    const double inwards = end == 0 ? by : -by;
    trial.foot[end] += inwards;
    trial.top[end] += inwards;
    const double close = close_at(trial) + kPrice * by;
    if (close >= least) continue;
    least = close;
    best = trial;
  }
  return best;
}

}  // namespace foldwright
