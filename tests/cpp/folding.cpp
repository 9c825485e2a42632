#include "folding.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "fold/certificate.h"
#include "search/tree_search.h"

namespace foldwright::testing {
namespace {

/// Whether a point of the plane of `t` lies in it or on its border. `normal`: of twice its area
bool is_inside(const Vec3& p, const Triangle3& t, const Vec3& normal) {
  for (int i = 0; i < 3; ++i) {
    const Vec3 edge = t[(i + 1) % 3] - t[i];
    // Triangles that mirror each other cross on their borders, where rounding must not decide.
    if (edge.cross(p - t[i]).dot(normal) < -1e-12 * normal.squaredNorm()) return false;
  }
  return true;
}

bool edges_pass_through(const Triangle3& of, const Triangle3& t) {
  const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
  for (int i = 0; i < 3; ++i) {
    const Vec3& p = of[i];
    const Vec3& q = of[(i + 1) % 3];
    const double above_p = normal.dot(p - t[0]);
    const double above_q = normal.dot(q - t[0]);
    if ((above_p > 0) == (above_q > 0)) continue;
    const Vec3 crossing = p + above_p / (above_p - above_q) * (q - p);
    if (is_inside(crossing, t, normal)) return true;
  }
  return false;
}

/// For triangles in one plane: some edges cross, or a corner of one lies in the other.
bool overlap_in_plane(const Triangle3& a, const Triangle3& b) {
  const Vec3 normal = (a[1] - a[0]).cross(a[2] - a[0]);
  const double rounding = 1e-12 * normal.squaredNorm();
  // On one line, rounding must not decide.
  const auto side = [&](const Vec3& p, const Vec3& q, const Vec3& r) {
    const double area = (q - p).cross(r - p).dot(normal);
    return std::abs(area) < rounding ? 0 : area;
  };
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) {
      const Vec3 &p = a[i], &q = a[(i + 1) % 3], &r = b[k], &s = b[(k + 1) % 3];
      if (side(p, q, r) * side(p, q, s) < 0 && side(r, s, p) * side(r, s, q) < 0) return true;
    }
  }
  const Vec3 normal_b = (b[1] - b[0]).cross(b[2] - b[0]);
  return is_inside(b[0], a, normal) || is_inside(a[0], b, normal_b);
}

double inradius(const Triangle3& t) {
  const double perimeter = (t[1] - t[0]).norm() + (t[2] - t[1]).norm() + (t[0] - t[2]).norm();
  return (t[1] - t[0]).cross(t[2] - t[0]).norm() / perimeter;
}

/// x -> turn x + shift.
struct Motion {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  Vec3 shift = Vec3::Zero();
  Vec3 operator()(const Vec3& p) const { return turn * p + shift; }
};

/// Rodrigues' formula.
Motion turn_around(const Vec3& point, const Vec3& axis, double angle) {
  Motion motion;
  for (int i = 0; i < 3; ++i) {
    const Vec3 v = Vec3::Unit(i);
    motion.turn.col(i) = std::cos(angle) * v + std::sin(angle) * axis.cross(v) +
                         (1 - std::cos(angle)) * axis.dot(v) * axis;
  }
  motion.shift = point - motion.turn * point;
  return motion;
}

Vec3 normal_of(const Mesh& mesh, int face) {
  const auto& [a, b, c] = mesh.faces[face];
  const Vec3& p = mesh.positions[a];
  return (mesh.positions[b] - p).cross(mesh.positions[c] - p).normalized();
}

/// An edge as the face on one of its sides runs along it, and how it is folded in the model.
struct Crease {
  Vec3 point, axis;
  double angle;  ///< valley positive
};

/// \pre the face has the edge
Crease crease_of(const Mesh& mesh, int edge, int face) {
  const auto& [v, w] = mesh.edges[edge].vertices;
  const auto& corners = mesh.faces[face];
  bool is_forward = false;
  for (int i = 0; i < 3; ++i) is_forward |= corners[i] == v && corners[(i + 1) % 3] == w;
  const Vec3& from = mesh.positions[is_forward ? v : w];
  const Vec3 axis = (mesh.positions[is_forward ? w : v] - from).normalized();
  const auto& sides = mesh.edges[edge].faces;
  const Vec3 own = normal_of(mesh, face);
  const Vec3 other = normal_of(mesh, sides[0] == face ? sides[1] : sides[0]);
  const double angle = -std::atan2(own.cross(other).dot(axis), own.dot(other));
  // Faces folded onto each other are a mountain.
  return {from, axis, angle > std::numbers::pi - 1e-9 ? -angle : angle};
}

}  // namespace

bool meet_by_edges(const Triangle3& a, const Triangle3& b) {
  if (edges_pass_through(a, b) || edges_pass_through(b, a)) return true;
  const Vec3 normal = (a[1] - a[0]).cross(a[2] - a[0]).normalized();
  const double size = (a[1] - a[0]).norm() + (b[1] - b[0]).norm();
  const bool in_one_plane = std::ranges::all_of(
      b, [&](const Vec3& p) { return std::abs(normal.dot(p - a[0])) < 1e-12 * size; });
  return in_one_plane && overlap_in_plane(a, b);
}

Triangle3 eroded_by_corners(const Triangle3& t, double depth) {
  depth = std::min(depth, 0.2 * inradius(t));
  Triangle3 smaller;
  for (int i = 0; i < 3; ++i) {
    const Vec3 next = (t[(i + 1) % 3] - t[i]).normalized();
    const Vec3 last = (t[(i + 2) % 3] - t[i]).normalized();
    const double half = 0.5 * std::atan2(next.cross(last).norm(), next.dot(last));
    smaller[i] = t[i] + depth / std::sin(half) * (next + last).normalized();
  }
  return smaller;
}

PlainFolder::PlainFolder(const Mesh& mesh, const DualGraph& graph, const FoldTree& folds,
                         double clearance, int root)
    : mesh_(&mesh), graph_(&graph), tree_(hang_tree(graph, folds, root)) {
  for (int panel = 0; panel < graph.panel_count(); ++panel) {
    for (const int face : graph.panel_faces(panel)) {
      const auto& [a, b, c] = mesh.faces[face];
      faces_.push_back({mesh.positions[a], mesh.positions[b], mesh.positions[c]});
      eroded_.push_back(eroded_by_corners(faces_.back(), clearance * graph.unit));
      panel_of_.push_back(panel);
    }
  }
}

std::vector<Triangle3> PlainFolder::moved(const std::vector<Triangle3>& faces,
                                          const std::vector<double>& angles) const {
  std::vector<Motion> motions(graph_->panel_count());
  for (const int panel : tree_.order) {
    const int parent = tree_.parent[panel];
    if (parent == -1) continue;
    const int edge = graph_->hinges[tree_.hinge[panel]].edges[0];
    const auto of_parent = graph_->panel_faces(parent);
    const auto& sides = mesh_->edges[edge].faces;
    const bool is_first = std::ranges::find(of_parent, sides[0]) != of_parent.end();
    const Crease crease = crease_of(*mesh_, edge, sides[is_first ? 0 : 1]);
    // Along the crease the parent lies on the left, so turning forwards takes the panel down.
    const Motion turn =
        turn_around(crease.point, crease.axis, crease.angle - angles[tree_.hinge[panel]]);
    motions[panel] = {motions[parent].turn * turn.turn, motions[parent](turn.shift)};
  }
  std::vector<Triangle3> result;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const Motion& motion = motions[panel_of_[i]];
    result.push_back({motion(faces[i][0]), motion(faces[i][1]), motion(faces[i][2])});
  }
  return result;
}

std::vector<Triangle3> PlainFolder::faces(const std::vector<double>& angles) const {
  return moved(faces_, angles);
}

std::vector<Triangle3> PlainFolder::eroded_faces(const std::vector<double>& angles) const {
  return moved(eroded_, angles);
}

/// Calls `visit(a, b)` for panels with faces that meet, until it returns true.
template <class Visit>
void PlainFolder::for_collisions(const std::vector<double>& angles, Visit&& visit) const {
  const std::vector<Triangle3> faces = eroded_faces(angles);
  std::vector<Vec3> centres;
  std::vector<double> radii;
  for (const Triangle3& t : faces) {
    centres.push_back((t[0] + t[1] + t[2]) / 3);
    double radius = 0;
    for (const Vec3& p : t) radius = std::max(radius, (p - centres.back()).norm());
    radii.push_back(radius);
  }
  for (std::size_t i = 0; i < faces.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      const double reach = radii[i] + radii[k];
      if ((centres[i] - centres[k]).squaredNorm() > reach * reach) continue;
      const int a = panel_of_[i];
      const int b = panel_of_[k];
      if (a == b || tree_.parent[a] == b || tree_.parent[b] == a) continue;
      if (meet_by_edges(faces[i], faces[k]) && visit(std::min(a, b), std::max(a, b))) return;
    }
  }
}

std::vector<std::array<int, 2>> PlainFolder::collisions(const std::vector<double>& angles) const {
  std::vector<std::array<int, 2>> pairs;
  for_collisions(angles, [&](int a, int b) {
    pairs.push_back({a, b});
    return false;
  });
  std::ranges::sort(pairs);
  pairs.erase(std::ranges::unique(pairs).begin(), pairs.end());
  return pairs;
}

bool PlainFolder::collides(const std::vector<double>& angles) const {
  bool found = false;
  for_collisions(angles, [&](int, int) { return found = true; });
  return found;
}

std::vector<double> between(const std::vector<double>& from, const std::vector<double>& to,
                            double s) {
  std::vector<double> angles;
  for (std::size_t i = 0; i < from.size(); ++i) angles.push_back((1 - s) * from[i] + s * to[i]);
  return angles;
}

std::vector<double> colliding_times(const PlainFolder& folder, const std::vector<double>& from,
                                    const std::vector<double>& to, int samples) {
  std::vector<double> times;
  for (int i = 0; i <= samples; ++i) {
    const double s = static_cast<double>(i) / samples;
    if (folder.collides(between(from, to, s))) times.push_back(s);
  }
  return times;
}

std::vector<double> colliding_times(const PlainFolder& folder, const DualGraph& graph,
                                    const FoldTree& folds, const FoldMotion& motion, int samples) {
  std::vector<double> times;
  for (int i = 0; i <= samples; ++i) {
    const double time = static_cast<double>(i) / samples;
    if (folder.collides(fold_angles(graph, folds, shares_at(motion, time)))) times.push_back(time);
  }
  return times;
}

std::string fault_of_motion(const PieceMotion& motion, const Net& net) {
  const auto& [kind, root, times, angles] = motion;
  if (kind != Folding::kLine && kind != Folding::kWaypoints) return "no motion";
  if (times.size() < 2 || times.size() != angles.size()) return "not as many keys as times";
  if ((kind == Folding::kLine) != (times.size() == 2)) return "a line that is none";
  if (times.front() != 0 || times.back() != 1) return "times that are not from 0 to 1";
  if (!std::ranges::is_sorted(times, std::less_equal<>())) return "times out of order";
  if (root < 0 || root >= std::ssize(net.faces)) return "a root that is not in the net";
  for (const std::vector<double>& key : angles) {
    if (key.size() != net.edges.size()) return "not as many angles as edges";
  }
  for (std::size_t i = 0; i < net.edges.size(); ++i) {
    const NetEdge& edge = net.edges[i];
    const bool folds =
        edge.assignment == Assignment::kMountain || edge.assignment == Assignment::kValley;
    if (angles.front()[i] != 0) return "a fold that is not flat at first";
    if (folds && angles.back()[i] != edge.angle) return "a fold that is not closed at last";
    for (const std::vector<double>& key : angles) {
      if (edge.assignment == Assignment::kCut && key[i] != 0) return "a cut that folds";
      const double most = std::abs(edge.angle);
      if (key[i] * edge.angle < 0 || std::abs(key[i]) > most) return "a fold that goes too far";
    }
  }
  return "";
}

std::vector<double> colliding_times(const JobResult& result, const DualGraph& whole,
                                    const Piece& piece, int samples) {
  std::vector<int> panels;
  for (int panel = 0; panel < whole.panel_count(); ++panel) {
    const int face = whole.panel_faces(panel)[0];
    if (std::ranges::binary_search(piece.net.faces, face)) panels.push_back(panel);
  }
  const DualGraph graph = restrict_to(whole, panels);
  std::vector<int> edge_of_mesh_edge(result.mesh.edges.size(), -1);
  for (std::size_t i = 0; i < piece.net.edges.size(); ++i) {
    const NetEdge& edge = piece.net.edges[i];
    if (edge.assignment != Assignment::kCut)
      edge_of_mesh_edge[edge.mesh_edge] = static_cast<int>(i);
  }
  FoldTree folds;
  std::vector<int> edge_of_hinge;
  for (int h = 0; h < graph.hinge_count(); ++h) {
    edge_of_hinge.push_back(edge_of_mesh_edge[graph.hinges[h].edges[0]]);
    if (edge_of_hinge.back() != -1) folds.push_back(h);
  }
  const PlainFolder folder(result.mesh, graph, folds);
  std::vector<double> colliding;
  std::size_t key = 0;
  for (int i = 0; i <= samples; ++i) {
    const double time = static_cast<double>(i) / samples;
    while (key + 2 < piece.motion.times.size() && time > piece.motion.times[key + 1]) ++key;
    const double start = piece.motion.times[key];
    const double s = (time - start) / (piece.motion.times[key + 1] - start);
    const std::vector<double> of_edges =
        between(piece.motion.angles[key], piece.motion.angles[key + 1], s);
    std::vector<double> angles;
    for (const int edge : edge_of_hinge) angles.push_back(edge == -1 ? 0 : of_edges[edge]);
    if (folder.collides(angles)) colliding.push_back(time);
  }
  return colliding;
}

FoldTree searched_net(const Mesh& mesh, const DualGraph& graph, std::uint64_t seed,
                      double clearance) {
  TreeSearch search(mesh, graph, {.clearance = clearance, .seed = seed});
  const auto state = search.step(std::numeric_limits<std::int64_t>::max());
  return state == TreeSearch::State::kFound ? search.best() : FoldTree{};
}

FoldTree net_that_does_not_fold_straight(const Mesh& mesh, const DualGraph& graph, int seeds) {
  const Foldable foldable = make_foldable(graph);
  for (int seed = 1; seed <= seeds; ++seed) {
    const FoldTree folds = searched_net(mesh, graph, static_cast<std::uint64_t>(seed), 0);
    if (folds.empty()) continue;
    Certificate straight(foldable, folds, straight_leg(graph));
    straight.step(std::numeric_limits<std::int64_t>::max());
    if (straight.state() == Certificate::State::kRefuted) return folds;
  }
  return {};
}

}  // namespace foldwright::testing
