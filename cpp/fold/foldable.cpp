#include "fold/foldable.h"

#include <algorithm>

#include "geometry/box_pairs.h"

namespace foldwright {
namespace {

// Slivers keep most of their width: 1 less the largest share of the inradius that erosion takes.
constexpr double kLeastScale = 0.8;

bool joined(const RootedTree& tree, int a, int b) {
  return tree.parent[a] == b || tree.parent[b] == a;
}

}  // namespace

Foldable make_foldable(const DualGraph& graph, double clearance) {
  Foldable foldable{&graph, {}, {}, {}, {}};
  for (const Hinge& hinge : graph.hinges) {
    const Vec2 along = (hinge.line[1] - hinge.line[0]).normalized();
    foldable.points.emplace_back(hinge.line[0].x(), hinge.line[0].y(), 0);
    foldable.axes.emplace_back(along.x(), along.y(), 0);
    foldable.lay.push_back(in_space(hinge.lay));
  }
  for (const Triangle2& face : graph.triangles) {
    foldable.faces.push_back(eroded(face, clearance * graph.unit, kLeastScale));
  }
  return foldable;
}

RigidMotion3 fold_beside(const Foldable& foldable, int hinge, int panel, double angle) {
  // With panels[0] on the left of the axis, turning forwards takes the other one down, away from
  // the printed side: a mountain.
  const RigidMotion3 motion =
      turn_about(foldable.points[hinge], foldable.axes[hinge], -angle) * foldable.lay[hinge];
  return foldable.graph->hinges[hinge].panels[1] == panel ? motion : motion.inverse();
}

FoldedLayout fold_up(const Foldable& foldable, const RootedTree& tree,
                     std::span<const double> angles) {
  FoldedLayout layout(foldable.graph->panel_count());
  for (std::size_t i = 1; i < tree.order.size(); ++i) {
    const int panel = tree.order[i];
    const int hinge = tree.hinge[panel];
    layout[panel] = layout[tree.parent[panel]] * fold_beside(foldable, hinge, panel, angles[hinge]);
  }
  return layout;
}

std::vector<double> fold_angles(const DualGraph& graph, double share) {
  std::vector<double> angles;
  for (const Hinge& hinge : graph.hinges) angles.push_back(share * hinge.angle);
  return angles;
}

std::vector<double> fold_angles(const DualGraph& graph, const FoldTree& folds,
                                std::span<const double> shares) {
  std::vector<double> angles(graph.hinges.size(), 0);
  for (std::size_t i = 0; i < folds.size(); ++i) {
    angles[folds[i]] = shares[i] * graph.hinges[folds[i]].angle;
  }
  return angles;
}

std::vector<std::array<int, 2>> colliding_panels(const Foldable& foldable, const RootedTree& tree,
                                                 const FoldedLayout& layout) {
  const DualGraph& graph = *foldable.graph;
  const double tolerance = kTouching * graph.unit;
  std::vector<Triangle3> faces;
  std::vector<Box3> boxes;
  std::vector<int> panel_of;
  for (int panel = 0; panel < graph.panel_count(); ++panel) {
    for (int i = graph.first_face[panel]; i < graph.first_face[panel + 1]; ++i) {
      faces.push_back(moved(layout[panel], foldable.faces[i]));
      boxes.push_back(box_of(faces.back()).grown(tolerance));
      panel_of.push_back(panel);
    }
  }
  std::vector<std::array<int, 2>> collisions;
  for (const auto& [i, j] : meeting_boxes(boxes)) {
    const auto [low, high] = std::minmax(panel_of[i], panel_of[j]);
    if (low == high || joined(tree, low, high)) continue;
    if (triangles_meet(faces[i], faces[j], tolerance)) collisions.push_back({low, high});
  }
  std::sort(collisions.begin(), collisions.end());
  collisions.erase(std::unique(collisions.begin(), collisions.end()), collisions.end());
  return collisions;
}

bool meets_itself(const Foldable& foldable) {
  const DualGraph& graph = *foldable.graph;
  // Any tree folds up to the model.
  const std::vector<double> weights(graph.hinges.size(), 0);
  const RootedTree tree = hang_tree(graph, minimum_spanning_tree(graph, weights));
  const auto meeting =
      colliding_panels(foldable, tree, fold_up(foldable, tree, fold_angles(graph, 1)));
  return std::any_of(meeting.begin(), meeting.end(), [&](const std::array<int, 2>& pair) {
    const auto hinges = graph.hinges_of(pair[0]);
    return std::none_of(hinges.begin(), hinges.end(),
                        [&](int h) { return graph.hinges[h].other(pair[0]) == pair[1]; });
  });
}

}  // namespace foldwright
