#include "repair/nesting.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "geometry/box_grid.h"
#include "geometry/triangle3.h"
#include "repair/edge_groups.h"

namespace foldwright {
namespace {

// By how much of the model's extent a body may stand out and still lie inside: what counts as a
// touch of faces.
constexpr double kSlack = 1e-3;

/// What there is to know of a body.
struct Body {
  Eigen::AlignedBox3d box;
  double volume = 0;  // six times it
  bool closed = true;
  int widest_face = -1;  // that with the largest shadow along the lines
  double shadow = 0;
};

/// Where a line meets the surface of a body.
struct Passage {
  double at;  ///< along the line
  int body;
  int enters;  ///< 1 on the way in, -1 on the way out
};

/// Lines of one direction through a surface.
class Lines {
 public:
  explicit Lines(const TriangleSoup& soup) : soup_(soup), grid_(soup.face_count(), cell(soup)) {
    for (int f = 0; f < soup.face_count(); ++f) grid_.insert(f, shadow_box(f));
  }

  /// Twice the area of a face's shadow, positive for one that the lines leave through.
  static double shadow(const TriangleSoup& soup, int face) {
    return frame().row(2).dot(area_vector(soup, face).transpose());
  }

  /// All passages of the line through a point, of closed bodies, in their order along it.
  std::vector<Passage> passages(const Vec3& point, std::span<const int> bodies,
                                std::span<const Body> all) const {
    const Vec3 place = frame() * point;
    const Vec2 foot = place.head<2>();
    std::vector<int> faces;
    grid_.visit({{foot.x(), foot.y()}, {foot.x(), foot.y()}}, [&](int face) {
      if (all[bodies[face]].closed) faces.push_back(face);
      return true;
    });
    // Large faces are met in several cells.
    std::ranges::sort(faces);
    faces.erase(std::ranges::unique(faces).begin(), faces.end());
    std::vector<Passage> found;
    for (const int face : faces) {
      if (const auto at = meet(face, foot)) {
        found.push_back({*at, bodies[face], shadow(soup_, face) > 0 ? -1 : 1});
      }
    }
    std::ranges::sort(found, {}, [](const Passage& p) { return std::pair(p.at, p.body); });
    return found;
  }

 private:
  const TriangleSoup& soup_;
  BoxGrid<2> grid_;

  /// Turns space so that the lines run along z: askew, since edges of drawn models run along axes
  /// and diagonals.
  static const Eigen::Matrix3d& frame() {
    static const Eigen::Matrix3d turned = [] {
      const Vec3 along = Vec3(0.381966, 0.842271, 0.573205).normalized();
      const Vec3 across = along.cross(Vec3(0.171573, -0.236068, 0.645751)).normalized();
      Eigen::Matrix3d rows;
      rows << across.transpose(), along.cross(across).transpose(), along.transpose();
      return rows;
    }();
    return turned;
  }

  Vec3 turned(int vertex) const { return frame() * soup_.positions[vertex]; }

  Box2 shadow_box(int face) const {
    Box2 box{{kHuge, kHuge}, {-kHuge, -kHuge}};
    for (const int v : soup_.faces[face]) {
      const Vec3 p = turned(v);
      box = box.joined({{p.x(), p.y()}, {p.x(), p.y()}});
    }
    return box;
  }

  static double cell(const TriangleSoup& soup) {
    double sum = 0;
    for (const auto& [a, b, c] : soup.faces) {
      sum += (soup.positions[b] - soup.positions[a]).norm();
    }
    return sum / soup.face_count();
  }

  /// On which side of an edge's shadow a point lies. The same for both faces of the edge, so that
  /// no line slips through between them.
  static double side(const Vec3& from, const Vec3& to, const Vec2& p) {
    return (to.x() - from.x()) * (p.y() - from.y()) - (to.y() - from.y()) * (p.x() - from.x());
  }

  /// How far along the line through a place it meets a face, if it does.
  std::optional<double> meet(int face, const Vec2& foot) const {
    const auto& corners = soup_.faces[face];
    std::array<double, 3> weights;
    int left = 0;
    for (int i = 0; i < 3; ++i) {
      const int from = corners[(i + 1) % 3];
      const int to = corners[(i + 2) % 3];
      const auto [low, high] = std::minmax(from, to);
      const double turn = side(turned(low), turned(high), foot);
      const bool is_left = (turn >= 0) == (from == low);
      weights[i] = std::abs(turn);
      left += is_left;
    }
    if (left != 0 && left != 3) return std::nullopt;
    const double sum = weights[0] + weights[1] + weights[2];
    if (sum == 0) return std::nullopt;
    double at = 0;
    for (int i = 0; i < 3; ++i) at += weights[i] / sum * turned(corners[i]).z();
    return at;
  }

  static constexpr double kHuge = std::numeric_limits<double>::max();
};

std::vector<Body> measure(const TriangleSoup& soup, std::span<const int> bodies) {
  std::vector<Body> all(1 + *std::ranges::max_element(bodies));
  for (int f = 0; f < soup.face_count(); ++f) {
    Body& body = all[bodies[f]];
    for (const int v : soup.faces[f]) body.box.extend(soup.positions[v]);
    body.volume += area_vector(soup, f).dot(soup.positions[soup.faces[f][0]]);
    const double shadow = std::abs(Lines::shadow(soup, f));
    if (shadow > body.shadow) body.shadow = shadow, body.widest_face = f;
  }
  for (const int h : border_half_edges(soup)) all[bodies[h / 3]].closed = false;
  return all;
}

Vec3 centroid(const TriangleSoup& soup, int face) {
  const auto& [a, b, c] = soup.faces[face];
  return (soup.positions[a] + soup.positions[b] + soup.positions[c]) / 3;
}

/// The middle of the longest stretch of a line that lies within a body; none if there is none.
std::optional<double> middle_of(std::span<const Passage> passages, int body) {
  std::optional<double> middle;
  double longest = 0;
  double since = 0;
  int depth = 0;
  for (const Passage& passage : passages) {
    if (passage.body != body) continue;
    if (depth > 0 && passage.at - since > longest) {
      longest = passage.at - since;
      middle = 0.5 * (passage.at + since);
    }
    depth += passage.enters;
    since = passage.at;
  }
  return middle;
}

/// The bodies that a place on a line is within, ascending.
std::vector<int> bodies_around(std::span<const Passage> passages, double place) {
  std::vector<std::pair<int, int>> depths;  // body, how often it was entered
  for (const Passage& passage : passages) {
    if (passage.at < place) depths.emplace_back(passage.body, passage.enters);
  }
  std::ranges::sort(depths);
  std::vector<int> around;
  for (std::size_t i = 0; i < depths.size();) {
    const int body = depths[i].first;
    int depth = 0;
    for (; i < depths.size() && depths[i].first == body; ++i) depth += depths[i].second;
    if (depth > 0) around.push_back(body);
  }
  return around;
}

}  // namespace

std::vector<int> find_nesting(const TriangleSoup& soup, std::span<const int> bodies,
                              std::span<const std::pair<int, int>> crossing) {
  const std::vector<Body> all = measure(soup, bodies);
  std::vector<int> outermost(all.size(), -1);
  if (all.size() < 2) return outermost;
  const Lines lines(soup);
  Eigen::AlignedBox3d whole;
  for (const Body& body : all) whole.extend(body.box);
  const Vec3 slack = Vec3::Constant(kSlack * whole.diagonal().norm());
  for (int b = 0; b < static_cast<int>(all.size()); ++b) {
    if (!all[b].closed || all[b].widest_face == -1) continue;
    const std::vector<Passage> passages =
        lines.passages(centroid(soup, all[b].widest_face), bodies, all);
    const std::optional<double> middle = middle_of(passages, b);
    if (!middle) continue;
    for (const int other : bodies_around(passages, *middle)) {
      const Body& around = all[other];
      const Eigen::AlignedBox3d room(around.box.min() - slack, around.box.max() + slack);
      const bool has_room = around.volume > all[b].volume && room.contains(all[b].box);
      const std::pair<int, int> pair = std::minmax(b, other);
      if (!has_room || std::ranges::binary_search(crossing, pair)) continue;
      int& found = outermost[b];
      if (found == -1 || around.volume > all[found].volume) found = other;
    }
  }
  return outermost;
}

}  // namespace foldwright
