#include "paper/room_profile.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace foldwright {
namespace {

// Room is lost next to slanted edges, by a bin each: a tenth of a millimetre is less than scissors
// can tell.
constexpr double kBin = 0.1;
constexpr int kLeastBins = 16;
constexpr int kMostBins = 320;

// Between a flap and what is beside it.
constexpr double kGap = 0.05;

// What is no higher above the base than this lies below it.
constexpr double kRounding = 1e-9;

constexpr double kStep = 0.5;      // in which heights go down
constexpr double kLeastTop = 0.3;  // mm; narrower than a pencil line

struct Span {
  double from, to;
};

/// Where the top of a flap of this height may lie for its triangle and the slope of its sides.
Span top_limits(double length, const Vec2& apex, const FlapShape& shape, double height) {
  if (height >= apex.y()) return {1, 0};
  const double share = height / apex.y();
  const double inset = height / std::tan(shape.angle);
  return {std::max(apex.x() * share, inset),
          std::min(length - (length - apex.x()) * share, length - inset)};
}

/// Least x of the left foot for a top that begins at `top`: the side lies below the profile.
double left_foot(const RoomProfile& profile, double top, double height) {
  double foot = 0;
  const double bin = profile.bin();
  for (std::size_t i = 0; i * bin < top && i < profile.room.size(); ++i) {
    const double room = profile.room[i];
    if (room >= height) continue;
    // The side is highest at the bin's right end.
    const double right = std::min((i + 1) * bin, top);
    foot = std::max(foot, (height * right - room * top) / (height - room));
  }
  return foot;
}

RoomProfile mirrored(const RoomProfile& profile) {
  RoomProfile back = profile;
  std::reverse(back.room.begin(), back.room.end());
  return back;
}

/// The start of the top nearest to `from` that has room for its side; none up to `to`.
std::optional<Span> left_side(const RoomProfile& profile, Span top, double height, double inset) {
  const double bin = profile.bin();
  for (double x = top.from; x + kLeastTop <= top.to; x += bin) {
    const double foot = left_foot(profile, x, height);
    if (foot <= x - inset + 1e-12) return Span{foot, x};
  }
  return std::nullopt;
}

/// The flap whose top lies within a run of bins that all have room for it.
std::optional<Trapezoid> flap_in(const RoomProfile& profile, Span run, double height,
                                 double inset) {
  const double length = profile.length;
  const auto left = left_side(profile, run, height, inset);
  if (!left) return std::nullopt;
  const Span rest = {length - run.to, length - left->to};
  const auto right = left_side(mirrored(profile), rest, height, inset);
  if (!right) return std::nullopt;
  return Trapezoid{height, {left->from, length - right->from}, {left->to, length - right->to}};
}

std::optional<Trapezoid> flap_of_height(const RoomProfile& profile, const Vec2& apex,
                                        const FlapShape& shape, double height) {
  const Span limits = top_limits(profile.length, apex, shape, height);
  const double inset = height / std::tan(shape.angle);
  const double bin = profile.bin();
  std::optional<Trapezoid> best;
  const std::size_t bins = profile.room.size();
  for (std::size_t i = 0; i < bins;) {
    if (profile.room[i] < height) {
      ++i;
      continue;
    }
    std::size_t end = i;
    while (end < bins && profile.room[end] >= height) ++end;
    const Span run = {std::max(limits.from, i * bin), std::min(limits.to, end * bin)};
    i = end;
    if (run.to - run.from < kLeastTop) continue;
    const auto flap = flap_in(profile, run, height, inset);
    if (flap && (!best || flap->top[1] - flap->top[0] > best->top[1] - best->top[0])) best = flap;
  }
  return best;
}

}  // namespace

RoomProfile open_room(double length, double most) {
  const int bins = std::clamp(static_cast<int>(std::ceil(length / kBin)), kLeastBins, kMostBins);
  return {length, std::vector<double>(bins, most)};
}

void lower_below(RoomProfile& profile, std::span<const Vec2> polygon) {
  const double bin = profile.bin();
  const int bins = static_cast<int>(profile.room.size());
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    Vec2 a = polygon[i];
    Vec2 b = polygon[(i + 1) % polygon.size()];
    if (a.x() > b.x()) std::swap(a, b);
    if (b.x() <= 0 || a.x() >= profile.length || std::max(a.y(), b.y()) < kRounding) continue;
    const int first = std::clamp(static_cast<int>(std::floor(a.x() / bin)), 0, bins - 1);
    const int last = std::clamp(static_cast<int>(std::floor(b.x() / bin)), 0, bins - 1);
    const double slope = b.x() > a.x() ? (b.y() - a.y()) / (b.x() - a.x()) : 0;
    for (int k = first; k <= last; ++k) {
      double low = std::min(a.y(), b.y());
      double high = std::max(a.y(), b.y());
      if (b.x() > a.x()) {
        const double from = a.y() + slope * (std::max(a.x(), k * bin) - a.x());
        const double to = a.y() + slope * (std::min(b.x(), (k + 1) * bin) - a.x());
        std::tie(low, high) = std::minmax(from, to);
      }
      if (high > kRounding) profile.room[k] = std::min(profile.room[k], std::max(0.0, low - kGap));
    }
  }
}

std::optional<Trapezoid> best_flap(const RoomProfile& profile, const Vec2& apex,
                                   const FlapShape& shape) {
  for (double height = shape.height;; height -= kStep) {
    height = std::max(height, shape.least);
    if (const auto flap = flap_of_height(profile, apex, shape, height)) return flap;
    if (height <= shape.least) return std::nullopt;
  }
}

double shortest_base(const FlapShape& shape) {
  return 2 * shape.least / std::tan(shape.angle) + kLeastTop;
}

}  // namespace foldwright
