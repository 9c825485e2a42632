#include "repair/join_faces.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

namespace foldwright {
namespace {

/// A face at an edge, seen along the edge from its lower to its higher vertex. Going round the edge
/// counter-clockwise, the solid inside begins at a face that `opens` and ends at one that does not.
struct Spoke {
  double angle;
  bool opens;
  int half_edge;
};

void join(Partners& partners, int half_edge, int other) {
  partners[half_edge] = other;
  partners[other] = half_edge;
}

/// The faces of a group in the order in which they are met going round the edge.
std::vector<Spoke> sorted_spokes(const TriangleSoup& soup, std::span<const int> group) {
  constexpr double kSameAngle = 1e-9;  // rounding of angles, in radians
  const auto [low, high] =
      std::minmax({start_vertex(soup, group.front()), end_vertex(soup, group.front())});
  const Vec3 axis = (soup.positions[high] - soup.positions[low]).normalized();
  const auto arm = [&](int h) {
    const Vec3 side = soup.positions[end_vertex(soup, next_half_edge(h))] - soup.positions[low];
    return Vec3(side - axis.dot(side) * axis);
  };
  const Vec3 x = arm(group.front()).normalized();
  const Vec3 y = axis.cross(x);
  std::vector<Spoke> spokes;
  for (const int h : group) {
    const Vec3 to_apex = arm(h);
    double angle = std::atan2(y.dot(to_apex), x.dot(to_apex));
    if (angle < -kSameAngle) angle += 2 * std::numbers::pi;
    spokes.push_back({angle, start_vertex(soup, h) == high, h});
  }
  const auto key = [](const Spoke& s) { return std::tuple(s.angle, s.opens, s.half_edge); };
  const auto before = [&](const Spoke& s, const Spoke& t) { return key(s) < key(t); };
  std::sort(spokes.begin(), spokes.end(), before);
  // Coincident faces: the one that closes a solid first, so that the wall is not taken for one.
  for (std::size_t i = 1; i < spokes.size(); ++i) {
    if (spokes[i].angle - spokes[i - 1].angle < kSameAngle) spokes[i].angle = spokes[i - 1].angle;
  }
  std::sort(spokes.begin(), spokes.end(), before);
  return spokes;
}

/// Pairs each face that opens with the next free one that closes, like brackets on a circle.
void match(std::span<const Spoke> spokes, Partners& partners) {
  std::vector<int> open;
  for (const bool again : {false, true}) {  // the second time for pairs across angle 0
    for (const Spoke& spoke : spokes) {
      if (partners[spoke.half_edge] != -1) continue;
      if (spoke.opens) {
        if (!again) open.push_back(spoke.half_edge);
      } else if (!open.empty()) {
        join(partners, open.back(), spoke.half_edge);
        open.pop_back();
      }
    }
  }
}

/// Matches the faces of each solid patch among themselves.
void match_within_solids(std::vector<Spoke> spokes, const Orientation& orientation,
                         Partners& partners) {
  const auto patch = [&](const Spoke& s) { return orientation.patches[s.half_edge / 3]; };
  std::stable_sort(spokes.begin(), spokes.end(),
                   [&](const Spoke& s, const Spoke& t) { return patch(s) < patch(t); });
  for (auto begin = spokes.begin(); begin != spokes.end();) {
    const auto end = std::find_if(begin, spokes.end(),
                                  [&](const Spoke& s) { return patch(s) != patch(*begin); });
    if (orientation.solid[patch(*begin)]) match({begin, end}, partners);
    begin = end;
  }
}

/// The two faces of a group that belong to one polygon of the file, of each that has just two.
void match_within_polygons(const TriangleSoup& soup, std::span<const int> group,
                           Partners& partners) {
  for (const int h : group) {
    int other = -1;
    int count = 0;
    for (const int k : group) {
      if (k == h || soup.source_faces[k / 3] != soup.source_faces[h / 3]) continue;
      ++count;
      other = k;
    }
    const bool opposite = count == 1 && start_vertex(soup, other) == end_vertex(soup, h);
    if (opposite && h < other) join(partners, h, other);
  }
}

/// Whether free faces of a group lie on each other: walls between rooms, given from both sides.
bool have_walls(std::span<const Spoke> spokes, const Partners& partners) {
  for (std::size_t i = 0; i < spokes.size(); ++i) {
    for (std::size_t j = i + 1; j < spokes.size(); ++j) {
      if (spokes[j].angle == spokes[i].angle && partners[spokes[i].half_edge] == -1 &&
          partners[spokes[j].half_edge] == -1) {
        return true;
      }
    }
  }
  return false;
}

/// Pairs free faces that go on straight across the edge, the straightest first. Both of closed
/// patches have to agree on what is outside.
void match_in_planes(const TriangleSoup& soup, std::span<const Spoke> spokes,
                     const Orientation& orientation, Partners& partners) {
  // What single precision hides of a plane of narrow triangles.
  constexpr double kStraight = 1e-3;
  std::vector<std::tuple<double, int, int>> pairs;  // how far from straight, half-edges
  for (std::size_t i = 0; i < spokes.size(); ++i) {
    for (std::size_t j = i + 1; j < spokes.size(); ++j) {
      const auto [h, k] = std::minmax(spokes[i].half_edge, spokes[j].half_edge);
      const double bend = std::abs(spokes[j].angle - spokes[i].angle - std::numbers::pi);
      const bool both_solid = orientation.solid[orientation.patches[h / 3]] &&
                              orientation.solid[orientation.patches[k / 3]];
      const bool agree = start_vertex(soup, h) == end_vertex(soup, k);
      if (bend < kStraight && (agree || !both_solid)) pairs.emplace_back(bend, h, k);
    }
  }
  std::sort(pairs.begin(), pairs.end());
  for (const auto& [bend, h, k] : pairs) {
    if (partners[h] == -1 && partners[k] == -1) join(partners, h, k);
  }
}

}  // namespace

Partners join_manifold_edges(const TriangleSoup& soup, const EdgeGroups& groups) {
  Partners partners(soup.faces.size() * 3, -1);
  for (int g = 0; g < groups.count(); ++g) {
    const std::span<const int> group = groups.group(g);
    if (group.size() == 2) {
      join(partners, group[0], group[1]);
    } else if (group.size() > 2) {
      match_within_polygons(soup, group, partners);
    }
  }
  return partners;
}

int join_nonmanifold_edges(const TriangleSoup& soup, const EdgeGroups& groups,
                           const Orientation& orientation, Partners& partners) {
  int count = 0;
  for (int g = 0; g < groups.count(); ++g) {
    const std::span<const int> group = groups.group(g);
    if (group.size() <= 2) continue;
    const bool is_inside_polygons =
        std::all_of(group.begin(), group.end(), [&](int h) { return partners[h] != -1; });
    if (is_inside_polygons) continue;
    ++count;
    const std::vector<Spoke> spokes = sorted_spokes(soup, group);
    match_within_solids(spokes, orientation, partners);
    if (!have_walls(spokes, partners)) match_in_planes(soup, spokes, orientation, partners);
    match(spokes, partners);
  }
  return count;
}

}  // namespace foldwright
