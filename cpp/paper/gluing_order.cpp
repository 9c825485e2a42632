#include "paper/gluing_order.h"

#include <cmath>
#include <tuple>
#include <utility>

#include "paper/seams.h"

namespace foldwright {
namespace {

double area_of(const Net& net) {
  double twice = 0;
  for (const auto& [a, b, c] : net.corners) {
    twice += cross(net.vertices[b] - net.vertices[a], net.vertices[c] - net.vertices[a]);
  }
  return 0.5 * twice;
}

/// To a millionth, so that rounding does not decide between borders of equal length.
double rounded(double length) { return std::round(1e6 * length) / 1e6; }

}  // namespace

std::vector<int> gluing_order(std::span<const Net> nets) {
  const int count = static_cast<int>(nets.size());
  std::vector<std::vector<std::pair<int, double>>> shared(count);  // other nets, lengths
  for (const Seam& seam : find_seams(nets)) {
    const int a = seam.sides[0].net;
    const int b = seam.sides[1].net;
    if (a == b) continue;
    shared[a].emplace_back(b, seam.sides[0].length());
    shared[b].emplace_back(a, seam.sides[0].length());
  }
  std::vector<double> areas, borders(count, 0);
  for (const Net& net : nets) areas.push_back(area_of(net));
  std::vector<char> joined(count, 0);
  std::vector<int> order;
  while (static_cast<int>(order.size()) < count) {
    int next = -1;
    for (int i = 0; i < count; ++i) {
      if (joined[i]) continue;
      const auto rank = [&](int net) { return std::tuple(rounded(borders[net]), areas[net]); };
      if (next == -1 || rank(i) > rank(next)) next = i;
    }
    joined[next] = 1;
    order.push_back(next);
    for (const auto& [other, length] : shared[next]) borders[other] += length;
  }
  return order;
}

}  // namespace foldwright
