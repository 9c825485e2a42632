#include "paper/joint_line.h"

#include <cmath>
#include <numbers>

namespace foldwright {

std::optional<Stroke> joint_line(const Net& net, const SeamSide& host) {
  // Folds flatter than this are not drawn, unless a person asks for it: then the line lies on one.
  constexpr double kDrawn = 3 * std::numbers::pi / 180;
  constexpr double kInset = 0.3;  // mm, so that it ends on the paper
  const NetEdge& edge = net.edges[host.edge()];
  const bool is_drawn = edge.assignment == Assignment::kCut || std::abs(edge.angle) >= kDrawn;
  if (is_drawn || host.length() < 3 * kInset) return std::nullopt;
  const Vec2 inset = kInset * (host.to - host.from) / host.length();
  return Stroke{host.from + inset, host.to - inset};
}

}  // namespace foldwright
