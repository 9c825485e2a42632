#include "outline_gaps.h"

#include <cmath>
#include <map>
#include <vector>

namespace foldwright::testing {
namespace {

constexpr double kStep = 0.25, kReach = 1, kHair = 0.2;
constexpr double kUpon = 1e-3;  // two lines so near are one

struct Line {
  Vec2 from, to;  ///< paper on the left
  bool of_flap;
};

/// The lines along which a piece is cut out: its cuts where no flap stands on them, and flaps.
std::vector<Line> outline_of(const Net& net, std::span<const Flap> flaps) {
  std::map<int, int> next;  // edges by the vertex at which they begin
  for (int e = 0; e < static_cast<int>(net.edges.size()); ++e) {
    if (net.edges[e].assignment == Assignment::kCut) next[net.edges[e].vertices[0]] = e;
  }
  std::vector<Line> lines;
  for (const Flap& flap : flaps) {
    const auto& [foot, near, far, end] = flap.corners;
    for (int v = flap.base[0]; v != flap.base[1];) {
      const auto found = next.find(v);
      if (found == next.end()) break;
      v = net.edges[found->second].vertices[1];
      next.erase(found);
    }
    lines.push_back({net.vertices[flap.base[0]], foot, false});
    lines.push_back({foot, near, true});
    lines.push_back({near, far, true});
    lines.push_back({far, end, true});
    lines.push_back({end, net.vertices[flap.base[1]], false});
  }
  for (const auto& [from, e] : next) {
    lines.push_back({net.vertices[from], net.vertices[net.edges[e].vertices[1]], false});
  }
  return lines;
}

/// How far it is from `p` along `ahead` to a line; infinite if they do not meet.
double distance_to(const Line& line, const Vec2& p, const Vec2& ahead) {
  const Vec2 along = line.to - line.from;
  const double across = cross(ahead, along);
  if (std::abs(across) < 1e-12) return HUGE_VAL;
  const Vec2 way = line.from - p;
  const double at = cross(way, ahead) / across;
  const double distance = cross(way, along) / across;
  return at < 0 || at > 1 || distance < -kUpon ? HUGE_VAL : distance;
}

bool meet(const Line& a, const Line& b) { return a.to == b.from || b.to == a.from; }

}  // namespace

void OutlineGaps::operator+=(const OutlineGaps& other) {
  length += other.length;
  close += other.close;
  corner += other.corner;
  hair += other.hair;
}

OutlineGaps outline_gaps(const Net& net, std::span<const Flap> flaps) {
  const std::vector<Line> lines = outline_of(net, flaps);
  OutlineGaps gaps;
  for (const Line& line : lines) {
    const double length = (line.to - line.from).norm();
    if (length < kUpon) continue;
    const Vec2 along = (line.to - line.from) / length;
    const Vec2 out(along.y(), -along.x());
    gaps.length += length;
    const int samples = static_cast<int>(std::ceil(length / kStep));
    for (int i = 0; i < samples; ++i) {
      const Vec2 p = line.from + (i + 0.5) / samples * length * along;
      double least = HUGE_VAL;
      const Line* nearest = nullptr;
      for (const Line& other : lines) {
        if (&other == &line) continue;
        const double distance = distance_to(other, p, out);
        if (distance < least) {
          least = distance;
          nearest = &other;
        }
      }
      if (least <= kUpon || least >= kReach) continue;
      const double share = length / samples;
      gaps.close += share;
      if (least < kHair) gaps.hair += share;
      if (!line.of_flap && !nearest->of_flap && meet(line, *nearest)) gaps.corner += share;
    }
  }
  return gaps;
}

}  // namespace foldwright::testing
