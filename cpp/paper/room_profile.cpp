#include "paper/room_profile.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace foldwright {
namespace {

// A base has so many bins: those of 3 mm still tell one flap from another, and long ones take no
// longer than they must.
constexpr int kLeastBins = 8;
constexpr int kMostBins = 320;

// Between a flap and what is beside it.
constexpr double kGap = 0.05;

// What is no higher above the base than this lies below it.
constexpr double kRounding = 1e-7;

constexpr double kStep = 0.5;      // in which heights go down
constexpr double kLeastTop = 0.3;  // mm; narrower than a pencil line

struct Span {
  double from, to;
};

/// A height at which a flap may end, and how far its two sides lean in up to there.
struct Level {
  double height;
  std::array<double, 2> insets;
};

/// Where the top of a flap of this height may lie for its cover and the slope of its sides.
Span top_limits(double length, const std::array<double, 2>& lean, const Level& level) {
  return {std::max(lean[0] * level.height, level.insets[0]),
          length - std::max(lean[1] * level.height, level.insets[1])};
}

/// A profile seen from one end.
struct FromEnd {
  const RoomProfile* profile;
  bool right;

  double operator[](std::size_t i) const {
    return profile->room[right ? profile->room.size() - 1 - i : i];
  }
};

/// Where a top may begin at the earliest: its side, as steep as may be, lies below the bins before
/// `end`, where the top has its run.
double earliest_top(const FromEnd& room, std::size_t end, const Level& level) {
  const double bin = room.profile->bin();
  const double inset = level.insets[room.right];
  double top = inset;
  for (std::size_t i = 0; i < end; ++i) {
    if (room[i] >= level.height) continue;
    // The side is highest at the bin's far end.
    top = std::max(top, (i + 1) * bin + inset * (1 - room[i] / level.height));
  }
  return top;
}

/// Where the foot of a side may stand at the earliest whose top begins at `top`.
double earliest_foot(const FromEnd& room, std::size_t end, double top, const Level& level) {
  const double bin = room.profile->bin();
  double foot = 0;
  for (std::size_t i = 0; i < end; ++i) {
    if (room[i] >= level.height) continue;
    const double far = (i + 1) * bin;
    foot = std::max(foot, (level.height * far - room[i] * top) / (level.height - room[i]));
  }
  return foot;
}

/// The flap whose top lies within the bins from `first` to before `last`, which all have room.
std::optional<Trapezoid> flap_in(const RoomProfile& profile, std::size_t first, std::size_t last,
                                 const Span& limits, const Level& level) {
  const double length = profile.length;
  const FromEnd left = {&profile, false};
  const FromEnd right = {&profile, true};
  const std::size_t after = profile.room.size() - last;
  const double from =
      std::max({limits.from, first * profile.bin(), earliest_top(left, first, level)});
  const double to =
      std::min({limits.to, last * profile.bin(), length - earliest_top(right, after, level)});
  if (to - from < kLeastTop) return std::nullopt;
  return Trapezoid{level.height,
                   {earliest_foot(left, first, from, level),
                    length - earliest_foot(right, after, length - to, level)},
                   {from, to}};
}

std::optional<Trapezoid> flap_of_height(const RoomProfile& profile,
                                        const std::array<double, 2>& lean, const FlapShape& shape,
                                        double height) {
  const auto& [first, second] = shape.angles;
  const Level level = {height, {height / std::tan(first), height / std::tan(second)}};
  const Span limits = top_limits(profile.length, lean, level);
  if (limits.to - limits.from < kLeastTop) return std::nullopt;
  std::optional<Trapezoid> best;
  const std::size_t bins = profile.room.size();
  for (std::size_t i = 0; i < bins;) {
    if (profile.room[i] < height) {
      ++i;
      continue;
    }
    const std::size_t first = i;
    while (i < bins && profile.room[i] >= height) ++i;
    const auto flap = flap_in(profile, first, i, limits, level);
    if (flap && (!best || flap->top[1] - flap->top[0] > best->top[1] - best->top[0])) best = flap;
  }
  return best;
}

}  // namespace

std::array<Vec2, 4> Trapezoid::corners() const {
  return {Vec2(foot[0], 0), Vec2(foot[1], 0), Vec2(top[1], height), Vec2(top[0], height)};
}

RoomProfile open_room(double length, double most, double bin) {
  const int bins = std::clamp(static_cast<int>(std::ceil(length / bin)), kLeastBins, kMostBins);
  return {length, most, std::vector<double>(bins, most)};
}

void lower_below(RoomProfile& profile, std::span<const Vec2> polygon) {
  const double bin = profile.bin();
  const int bins = static_cast<int>(profile.room.size());
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    Vec2 a = polygon[i];
    Vec2 b = polygon[(i + 1) % polygon.size()];
    const bool is_below = a.x() < b.x();  // the polygon lies above this side
    if (!is_below) std::swap(a, b);
    if (b.x() <= kRounding || a.x() >= profile.length - kRounding) continue;
    if (std::min(a.y(), b.y()) - kGap >= profile.most) continue;
    // A side along the base leaves no room above it, but is no obstacle to what lies above.
    const double least = is_below ? -kRounding : kRounding;
    if (std::max(a.y(), b.y()) < least) continue;
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
      if (high > least) {
        profile.room[k] = std::min(profile.room[k], std::max(0.0, low - kGap));
      }
    }
  }
}

void lower_below(RoomProfile& profile, const FlapCover& cover) {
  for (const auto& border : cover.borders) lower_below(profile, border);
}

std::optional<Trapezoid> best_flap(const RoomProfile& profile, const std::array<double, 2>& lean,
                                   const FlapShape& shape) {
  for (double height = shape.height;; height -= kStep) {
    height = std::max(height, shape.least);
    if (const auto flap = flap_of_height(profile, lean, shape, height)) return flap;
    if (height <= shape.least) return std::nullopt;
  }
}

double shortest_base(const FlapShape& shape) {
  const auto& [first, second] = shape.angles;
  return shape.least * (1 / std::tan(first) + 1 / std::tan(second)) + kLeastTop;
}

}  // namespace foldwright
