#include "unfold/congruence.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "mesh/panel_places.h"

namespace foldwright {
namespace {

// Lengths, areas and places of congruent surfaces differ by less than this, in mean edge lengths:
// files with six decimals come to a tenth of it.
constexpr double kTolerance = 1e-3;

// Normals, whose error grows with how narrow panels are, differ by less.
constexpr double kNormalTolerance = 1e-2;

// Angles that tell which hinges a person would take for equal, in radians.
constexpr double kAngleTolerance = 1e-2;

// A direction that no row of hinges of a usual model is at right angles to.
const Vec3 kSkew = Vec3(0.3581, 0.4787, 0.8016);

/// What identifies a hinge in space.
struct HingePlace {
  Vec3 middle;
  Vec3 along;                   ///< unit vector, either way
  std::array<Vec3, 2> normals;  ///< of its panels, unit vectors
};

/// A graph in space: what two congruent ones have in common.
struct Shape {
  const DualGraph* graph;
  std::vector<PanelPlace> panels;
  std::vector<HingePlace> hinges;
};

Shape make_shape(const Mesh& mesh, const DualGraph& graph) {
  Shape shape{&graph, panel_places(mesh, graph), {}};
  for (const Hinge& hinge : graph.hinges) {
    Vec3 middle = Vec3::Zero();
    double length = 0;
    for (const int e : hinge.edges) {
      const auto& [v, w] = mesh.edges[e].vertices;
      const double edge = (mesh.positions[w] - mesh.positions[v]).norm();
      middle += edge * 0.5 * (mesh.positions[v] + mesh.positions[w]);
      length += edge;
    }
    const auto& [v, w] = mesh.edges[hinge.edges[0]].vertices;
    const Vec3 along = (mesh.positions[w] - mesh.positions[v]).normalized();
    const auto& [a, b] = hinge.panels;
    shape.hinges.push_back(
        {middle / length, along, {shape.panels[a].normal, shape.panels[b].normal}});
  }
  return shape;
}

/// A rotation, or a reflection, and a shift.
struct Placement3 {
  Eigen::Matrix3d turn;
  Vec3 shift;
  Vec3 operator()(const Vec3& p) const { return turn * p + shift; }
};

/// Along the hinge, upwards between its panels, and across.
Eigen::Matrix3d frame_at(const HingePlace& hinge) {
  Eigen::Matrix3d frame;
  frame.col(0) = hinge.along;
  frame.col(1) = (hinge.normals[0] + hinge.normals[1]).normalized();
  frame.col(2) = frame.col(0).cross(frame.col(1));
  return frame;
}

/// The way that lays one hinge onto another: `flip` turns it around, `mirror` reflects across.
Placement3 placement(const HingePlace& from, const HingePlace& to, bool flip, bool mirror) {
  Eigen::Matrix3d goal = frame_at(to);
  if (flip) goal.col(0) *= -1;
  if (flip != mirror) goal.col(2) *= -1;
  const Eigen::Matrix3d turn = goal * frame_at(from).transpose();
  return {turn, to.middle - turn * from.middle};
}

/// Finds hinges by where they are.
class HingeFinder {
 public:
  explicit HingeFinder(const Shape& shape) : shape_(shape), order_(shape.hinges.size()) {
    std::iota(order_.begin(), order_.end(), 0);
    std::ranges::sort(order_, {}, [&](int h) { return key(h); });
  }

  /// The free hinge that lies at `place`, with its distance; -1 if none does.
  std::pair<int, double> at(const HingePlace& place, double reach,
                            const std::vector<char>& is_taken) const {
    std::pair<int, double> best = {-1, reach};
    const double wanted = kSkew.dot(place.middle);
    auto it = std::ranges::lower_bound(order_, wanted - reach, {}, [&](int h) { return key(h); });
    for (; it != order_.end() && key(*it) <= wanted + reach; ++it) {
      const HingePlace& hinge = shape_.hinges[*it];
      const double distance = (hinge.middle - place.middle).norm();
      const Vec3 up = hinge.normals[0] + hinge.normals[1] - place.normals[0] - place.normals[1];
      const bool lies_there = distance < best.second && up.norm() < kNormalTolerance &&
                              hinge.along.cross(place.along).norm() < kNormalTolerance;
      if (lies_there && !is_taken[*it]) best = {*it, distance};
    }
    return best;
  }

 private:
  double key(int hinge) const { return kSkew.dot(shape_.hinges[hinge].middle); }

  const Shape& shape_;
  std::vector<int> order_;
};

/// What costs next to nothing to see: most graphs differ there.
bool may_be_congruent(const DualGraph& first, const DualGraph& second) {
  if (first.hinge_count() == 0 || first.panel_count() != second.panel_count() ||
      first.hinge_count() != second.hinge_count()) {
    return false;
  }
  const auto area = [](const DualGraph& graph) {
    return std::accumulate(graph.areas.begin(), graph.areas.end(), 0.0);
  };
  const double tolerance = kTolerance * first.unit * first.unit * first.panel_count();
  return std::abs(area(first) - area(second)) <= tolerance;
}

bool look_alike(const Hinge& a, const Hinge& b, double unit) {
  return std::abs(a.length - b.length) <= kTolerance * unit &&
         std::abs(a.angle - b.angle) <= kAngleTolerance && a.stays_fold == b.stays_fold;
}

/// Where a panel of the first graph may lie, of two; -1 if it fits none.
int panel_at(const Shape& second, std::array<int, 2> panels, const Vec3& centroid, double area) {
  const double unit = second.graph->unit;
  for (const int panel : panels) {
    if ((second.panels[panel].centroid - centroid).norm() <= kTolerance * unit &&
        std::abs(second.graph->areas[panel] - area) <= kTolerance * unit * unit) {
      return panel;
    }
  }
  return -1;
}

/// The congruence that a placement of the first graph is, if it is one.
std::optional<Congruence> try_placement(const Shape& first, const Shape& second,
                                        const HingeFinder& finder, const Placement3& place) {
  const DualGraph& a = *first.graph;
  const DualGraph& b = *second.graph;
  Congruence found;
  found.panels.assign(a.panel_count(), -1);
  std::vector<char> is_taken(b.hinge_count(), 0);
  std::vector<char> is_met(b.panel_count(), 0);
  for (int h = 0; h < a.hinge_count(); ++h) {
    const HingePlace& hinge = first.hinges[h];
    const HingePlace moved = {place(hinge.middle),
                              place.turn * hinge.along,
                              {place.turn * hinge.normals[0], place.turn * hinge.normals[1]}};
    const auto [there, distance] = finder.at(moved, kTolerance * a.unit, is_taken);
    if (there == -1 || !look_alike(a.hinges[h], b.hinges[there], a.unit)) return std::nullopt;
    is_taken[there] = 1;
    found.hinges.push_back(there);
    found.error = std::max(found.error, distance / a.unit);
    for (const int panel : a.hinges[h].panels) {
      const int lies_on = panel_at(second, b.hinges[there].panels,
                                   place(first.panels[panel].centroid), a.areas[panel]);
      if (lies_on == -1) return std::nullopt;
      int& known = found.panels[panel];
      if (known == -1 && !std::exchange(is_met[lies_on], 1)) known = lies_on;
      if (known != lies_on) return std::nullopt;
    }
  }
  return found;
}

/// The hinge that fewest others look like, of these the longest: where to begin. Those that are
/// folded shut have no upwards.
int rarest_hinge(const Shape& shape) {
  const double unit = shape.graph->unit;
  const auto signature = [&](const Hinge& hinge) {
    return std::pair(std::lround(hinge.length / (10 * kTolerance * unit)),
                     std::lround(hinge.angle / kAngleTolerance));
  };
  std::map<std::pair<long, long>, int> counts;
  for (const Hinge& hinge : shape.graph->hinges) ++counts[signature(hinge)];
  int best = -1;
  std::pair<int, double> least;
  for (int h = 0; h < shape.graph->hinge_count(); ++h) {
    const auto& [n0, n1] = shape.hinges[h].normals;
    if ((n0 + n1).norm() < 0.1) continue;
    const Hinge& hinge = shape.graph->hinges[h];
    const std::pair<int, double> rank = {counts[signature(hinge)], -hinge.length};
    if (best == -1 || rank < least) best = h, least = rank;
  }
  return best;
}

}  // namespace

std::optional<Congruence> find_congruence(const Mesh& mesh, const DualGraph& first,
                                          const DualGraph& second) {
  if (!may_be_congruent(first, second)) return std::nullopt;
  const Shape from = make_shape(mesh, first);
  const Shape to = make_shape(mesh, second);
  const int start = rarest_hinge(from);
  if (start == -1) return std::nullopt;
  const HingeFinder finder(to);
  for (const bool mirror : {false, true}) {
    for (int h = 0; h < second.hinge_count(); ++h) {
      if (!look_alike(first.hinges[start], second.hinges[h], first.unit)) continue;
      for (const bool flip : {false, true}) {
        const Placement3 place = placement(from.hinges[start], to.hinges[h], flip, mirror);
        std::optional<Congruence> found = try_placement(from, to, finder, place);
        if (!found) continue;
        found->is_mirrored = mirror;
        return found;
      }
    }
  }
  return std::nullopt;
}

}  // namespace foldwright
