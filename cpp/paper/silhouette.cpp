#include "paper/silhouette.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace foldwright {
namespace {

constexpr int kDirections = 32;
constexpr double kStep = 2 * 3.14159265358979323846 / kDirections;

struct Axes {
  std::array<float, kDirections / 2> x, y;
  Axes() {
    for (int i = 0; i < kDirections / 2; ++i) {
      x[i] = static_cast<float>(std::cos(kStep * i));
      y[i] = static_cast<float>(std::sin(kStep * i));
    }
  }
};
const Axes kAxisOf;

}  // namespace

Silhouette::Silhouette() { clear(); }

void Silhouette::clear() {
  low_.fill(std::numeric_limits<float>::max());
  high_.fill(std::numeric_limits<float>::lowest());
}

void Silhouette::add(const Vec2& point) {
  const auto px = static_cast<float>(point.x());
  const auto py = static_cast<float>(point.y());
  for (int i = 0; i < kAxes; ++i) {
    const float along = px * kAxisOf.x[i] + py * kAxisOf.y[i];
    low_[i] = std::min(low_[i], along);
    high_[i] = std::max(high_[i], along);
  }
}

double Silhouette::reach(int direction) const {
  const int i = (direction + kDirections) % kDirections;
  return i < kAxes ? high_[i] : -low_[i - kAxes];
}

double Silhouette::area() const {
  if (high_[0] < low_[0]) return 0;
  // Half the sum over the sides of their distance from the origin times their length.
  double twice = 0;
  for (int i = 0; i < kDirections; ++i) {
    const double side = (reach(i - 1) + reach(i + 1) - 2 * reach(i) * std::cos(kStep));
    twice += reach(i) * side / std::sin(kStep);
  }
  return 0.5 * twice;
}

double Silhouette::excess(const Extent& room) const {
  double least = std::numeric_limits<double>::max();
  for (int i = 0; i < kAxes; ++i) {
    const int across = (i + kAxes / 2) % kAxes;  // a right angle on
    const double width = high_[i] - low_[i];
    const double height = high_[across] - low_[across];
    least =
        std::min(least, std::max(0.0, width - room.width) + std::max(0.0, height - room.height));
  }
  return high_[0] < low_[0] ? 0 : least;
}

}  // namespace foldwright
