#include "mesh/close_cracks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "geometry/union_find.h"
#include "mesh/edge_groups.h"
#include "mesh/segment_query.h"
#include "mesh/t_junctions.h"

namespace foldwright {
namespace {

// Cracks are narrow against what they separate.
constexpr double kShareOfEdge = 0.1;

/// Per vertex how wide a crack beside it may be.
std::vector<double> reaches_of(const TriangleSoup& soup, double widest) {
  std::vector<double> shortest(soup.positions.size(), std::numeric_limits<double>::infinity());
  for (int h = 0; h < 3 * soup.face_count(); ++h) {
    const auto [a, b] = std::pair(start_vertex(soup, h), end_vertex(soup, h));
    const double length = (soup.positions[b] - soup.positions[a]).norm();
    shortest[a] = std::min(shortest[a], length);
    shortest[b] = std::min(shortest[b], length);
  }
  for (double& length : shortest) length = std::min(widest, kShareOfEdge * length);
  return shortest;
}

/// Two border edges that face each other: `ends[i]` of the second meets the i-th end of the first.
struct Facing {
  double distance;  ///< between the ends further apart
  int half_edge;
  int other;
  std::array<int, 2> ends;

  auto key() const { return std::tie(distance, half_edge, other, ends); }
};

/// Whether the faces at two border edges that are to be joined would lie on each other.
bool lie_on_each_other(const TriangleSoup& soup, int h, int other) {
  constexpr double kOpening = 5 * 3.14159265358979323846 / 180;  // less is no crease
  const Vec3 axis =
      (soup.positions[end_vertex(soup, h)] - soup.positions[start_vertex(soup, h)]).normalized();
  const auto arm = [&](int side) {
    const Vec3 to_apex = soup.positions[end_vertex(soup, next_half_edge(side))] -
                         soup.positions[start_vertex(soup, side)];
    return Vec3(to_apex - axis.dot(to_apex) * axis);
  };
  const Vec3 a = arm(h);
  const Vec3 b = arm(other);
  return std::atan2(a.cross(b).norm(), a.dot(b)) < kOpening;
}

class CrackFinder {
 public:
  CrackFinder(const TriangleSoup& soup, double widest)
      : soup_(soup),
        reaches_(reaches_of(soup, widest)),
        border_(border_half_edges(soup)),
        vertices_(vertices_of(soup, border_)),
        points_(points_of(soup, vertices_)),
        query_(points_) {
    for (const int h : border_) {
      border_at_[{start_vertex(soup, h), end_vertex(soup, h)}] = h;
      border_at_[{end_vertex(soup, h), start_vertex(soup, h)}] = h;
    }
  }

  /// Pairs of border edges to be joined, each edge in one at most; the nearest go first.
  std::vector<Facing> find() const {
    std::vector<Facing> candidates;
    for (const int h : border_) add_candidates(h, candidates);
    std::sort(candidates.begin(), candidates.end(),
              [](const Facing& a, const Facing& b) { return a.key() < b.key(); });
    std::vector<char> taken(3 * soup_.faces.size(), false);
    std::vector<Facing> found;
    for (const Facing& facing : candidates) {
      if (taken[facing.half_edge] || taken[facing.other]) continue;
      taken[facing.half_edge] = taken[facing.other] = true;
      found.push_back(facing);
    }
    return found;
  }

 private:
  const TriangleSoup& soup_;
  std::vector<double> reaches_;
  std::vector<int> border_;
  std::vector<int> vertices_;
  std::vector<Vec3> points_;
  SegmentQuery query_;
  std::map<std::pair<int, int>, int> border_at_;  // by its ends, in both directions

  static std::vector<Vec3> points_of(const TriangleSoup& soup, const std::vector<int>& vertices) {
    std::vector<Vec3> points;
    for (const int v : vertices) points.push_back(soup.positions[v]);
    return points;
  }

  double distance(int v, int w) const { return (soup_.positions[v] - soup_.positions[w]).norm(); }

  /// Border vertices across a crack from one, and itself.
  std::vector<int> across(int vertex) const {
    const Vec3& p = soup_.positions[vertex];
    std::vector<int> found;
    for (const int i : query_.near(p, p, reaches_[vertex])) {
      if (distance(vertex, vertices_[i]) <= reaches_[vertices_[i]]) found.push_back(vertices_[i]);
    }
    return found;
  }

  void add_candidates(int h, std::vector<Facing>& candidates) const {
    const std::array<int, 2> ends = {start_vertex(soup_, h), end_vertex(soup_, h)};
    for (const int v : across(ends[0])) {
      for (const int w : across(ends[1])) {
        const auto entry = border_at_.find({v, w});
        if (entry == border_at_.end() || entry->second <= h) continue;
        if (lie_on_each_other(soup_, h, entry->second)) continue;
        const double apart = std::max(distance(ends[0], v), distance(ends[1], w));
        candidates.push_back({apart, h, entry->second, {v, w}});
      }
    }
  }
};

/// Moves vertices that are to be one to the middle and lets the lowest stand for all.
void join_vertices(TriangleSoup& soup, const std::vector<Facing>& cracks) {
  UnionFind joined(static_cast<int>(soup.positions.size()));
  for (const Facing& crack : cracks) {
    joined.join(start_vertex(soup, crack.half_edge), crack.ends[0]);
    joined.join(end_vertex(soup, crack.half_edge), crack.ends[1]);
  }
  std::map<int, std::vector<int>> groups;  // by their lowest vertex
  for (int v = 0; v < static_cast<int>(soup.positions.size()); ++v) {
    if (joined.find(v) != v) groups[joined.find(v)].push_back(v);
  }
  soup.errors.resize(soup.positions.size(), 0);
  for (const auto& [lowest, others] : groups) {
    Vec3 sum = soup.positions[lowest];
    for (const int v : others) sum += soup.positions[v];
    const Vec3 middle = sum / static_cast<double>(others.size() + 1);
    double moved = (middle - soup.positions[lowest]).norm();
    for (const int v : others) moved = std::max(moved, (middle - soup.positions[v]).norm());
    soup.positions[lowest] = middle;
    soup.errors[lowest] += moved;
  }
  for (auto& face : soup.faces) {
    for (int& v : face) v = joined.find(v);
  }
}

}  // namespace

ClosedCracks close_cracks(TriangleSoup& soup, double widest) {
  ClosedCracks closed;
  const std::vector<Facing> cracks = CrackFinder(soup, widest).find();
  for (const Facing& crack : cracks) closed.width = std::max(closed.width, crack.distance);
  closed.edges = 2 * static_cast<int>(cracks.size());
  join_vertices(soup, cracks);
  const ClosedCracks cut = close_t_junctions(soup, reaches_of(soup, widest));
  return {closed.edges + cut.edges, std::max(closed.width, cut.width)};
}

}  // namespace foldwright
