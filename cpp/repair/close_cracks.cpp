#include "repair/close_cracks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "geometry/union_find.h"
#include "repair/edge_groups.h"
#include "repair/segment_query.h"
#include "repair/t_junctions.h"

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

/// Two border vertices that face each other across a crack.
struct Facing {
  double distance;
  int vertex;
  int other;
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
      borders_at_[start_vertex(soup, h)].push_back(h);
      borders_at_[end_vertex(soup, h)].push_back(h);
    }
  }

  /// Pairs of vertices to be joined.
  std::vector<Facing> find() const {
    std::vector<Facing> found;
    for (const int v : vertices_) {
      for (const int w : across(v)) {
        if (v < w && face_each_other(v, w)) found.push_back({distance(v, w), v, w});
      }
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
  std::map<int, std::vector<int>> borders_at_;  // border half-edges at a vertex

  static std::vector<Vec3> points_of(const TriangleSoup& soup, const std::vector<int>& vertices) {
    std::vector<Vec3> points;
    for (const int v : vertices) points.push_back(soup.positions[v]);
    return points;
  }

  double distance(int v, int w) const { return (soup_.positions[v] - soup_.positions[w]).norm(); }

  /// Border vertices across a crack from one.
  std::vector<int> across(int vertex) const {
    const Vec3& p = soup_.positions[vertex];
    std::vector<int> found;
    for (const int i : query_.near(p, p, reaches_[vertex])) {
      if (distance(vertex, vertices_[i]) <= reaches_[vertices_[i]]) found.push_back(vertices_[i]);
    }
    return found;
  }

  /// Whether a border edge at one vertex runs along one at the other, on the other side of a crack.
  bool face_each_other(int v, int w) const {
    for (const int h : borders_at_.at(v)) {
      for (const int k : borders_at_.at(w)) {
        if (h != k && run_along(h, v, k, w) && !lie_on_each_other(soup_, h, k)) return true;
      }
    }
    return false;
  }

  /// Whether the shorter of two edges from `v` and from `w` ends at the other one.
  bool run_along(int h, int v, int k, int w) const {
    const int far_v = start_vertex(soup_, h) == v ? end_vertex(soup_, h) : start_vertex(soup_, h);
    const int far_w = start_vertex(soup_, k) == w ? end_vertex(soup_, k) : start_vertex(soup_, k);
    return is_at_edge(far_v, w, far_w) || is_at_edge(far_w, v, far_v);
  }

  bool is_at_edge(int vertex, int start, int end) const {
    const Vec3& a = soup_.positions[start];
    const Vec3 along = soup_.positions[end] - a;
    const Vec3 to_vertex = soup_.positions[vertex] - a;
    const double share = std::clamp(along.dot(to_vertex) / along.squaredNorm(), 0.0, 1.0);
    return (to_vertex - share * along).norm() <= std::min(reaches_[vertex], reaches_[start]);
  }
};

/// Moves vertices that are to be one to the middle and lets the lowest stand for all. Returns how
/// far the vertex that moved furthest did.
double join_vertices(TriangleSoup& soup, const std::vector<Facing>& cracks) {
  UnionFind joined(static_cast<int>(soup.positions.size()));
  for (const Facing& crack : cracks) {
    joined.join(crack.vertex, crack.other);
  }
  std::map<int, std::vector<int>> groups;  // by their lowest vertex
  for (int v = 0; v < static_cast<int>(soup.positions.size()); ++v) {
    if (joined.find(v) != v) groups[joined.find(v)].push_back(v);
  }
  soup.errors.resize(soup.positions.size(), 0);
  double furthest = 0;
  for (const auto& [lowest, others] : groups) {
    Vec3 sum = soup.positions[lowest];
    for (const int v : others) sum += soup.positions[v];
    const Vec3 middle = sum / static_cast<double>(others.size() + 1);
    double moved = (middle - soup.positions[lowest]).norm();
    for (const int v : others) moved = std::max(moved, (middle - soup.positions[v]).norm());
    soup.positions[lowest] = middle;
    soup.errors[lowest] += moved;
    furthest = std::max(furthest, moved);
  }
  for (auto& face : soup.faces) {
    for (int& v : face) v = joined.find(v);
  }
  return furthest;
}

}  // namespace

ClosedCracks close_cracks(TriangleSoup& soup, double widest) {
  const auto borders = [&] { return static_cast<int>(border_half_edges(soup).size()); };
  const int before = borders();
  if (before == 0) return {};
  ClosedCracks closed;
  const std::vector<Facing> cracks = CrackFinder(soup, widest).find();
  for (const Facing& crack : cracks) closed.width = std::max(closed.width, crack.distance);
  const double joined = join_vertices(soup, cracks);
  const ClosedCracks junctions = close_t_junctions(soup, reaches_of(soup, widest));
  closed.width = std::max(closed.width, junctions.width);
  closed.moved = joined + junctions.moved;
  closed.edges = std::max(0, before - borders());
  return closed;
}

}  // namespace foldwright
