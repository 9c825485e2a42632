#include "paper/grain.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

namespace foldwright {
namespace {

constexpr double kQuarter = std::numbers::pi / 2;

// Lines within 0.2 degrees look parallel.
constexpr double kParallel = 0.2 * std::numbers::pi / 180;

// The net of a cube has all its lines in one grain, those of triangles have a third or less.
constexpr double kLeastShare = 0.3;

// A single triangle with a right angle has two lines, and looks as well in any turn.
constexpr std::ptrdiff_t kLeastLines = 3;

struct Line {
  double angle;  ///< within a quarter turn
  double length;
};

std::vector<Line> lines_of(const Net& net) {
  std::vector<Line> lines;
  for (const NetEdge& edge : net.edges) {
    if (edge.assignment == Assignment::kFlat) continue;
    const Vec2 along = net.vertices[edge.vertices[1]] - net.vertices[edge.vertices[0]];
    double angle = std::fmod(std::atan2(along.y(), along.x()) + 4 * kQuarter, kQuarter);
    // Upright lines come out at either end of the range by rounding.
    if (angle > kQuarter - 1e-9) angle = 0;
    lines.push_back({angle, along.norm()});
  }
  std::ranges::sort(lines, {}, [](const Line& line) { return std::pair(line.angle, line.length); });
  return lines;
}

}  // namespace

std::optional<double> grain_of(const Net& net) {
  std::vector<Line> lines = lines_of(net);
  double total = 0;
  for (const Line& line : lines) total += line.length;
  // Once more behind the last, so that a run may pass the end of the range.
  const std::size_t count = lines.size();
  for (std::size_t i = 0; i < count; ++i) {
    lines.push_back({lines[i].angle + kQuarter, lines[i].length});
  }
  double best = 0;
  std::pair<std::size_t, std::size_t> run = {0, 0};
  double length = 0;
  std::size_t end = 0;
  for (std::size_t i = 0; i < count; ++i) {
    while (end < i + count && lines[end].angle - lines[i].angle <= kParallel) {
      length += lines[end++].length;
    }
    if (length > best) {
      best = length;
      run = {i, end};
    }
    length -= lines[i].length;
  }
  const std::span<const Line> parallel(lines.begin() + run.first, lines.begin() + run.second);
  if (std::ssize(parallel) < kLeastLines || best < kLeastShare * total) return std::nullopt;
  // That of a line, as a mean would be that of none.
  return std::fmod(std::ranges::max(parallel, {}, &Line::length).angle, kQuarter);
}

}  // namespace foldwright
