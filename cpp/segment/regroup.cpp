#include "segment/regroup.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>

#include "mesh/vertex_turn.h"
#include "segment/segment.h"

namespace foldwright {
namespace {

constexpr int kOutside = -1;

// Share of its balance, negative over positive curvature, that a part must have left at most
// together with a neighbour.
constexpr double kBetter = 0.5;

// What makes a part a saddle without a net. Of 284 parts of a bust of 1000 to 20,000 faces 13 are
// like this, of which a search leaves 11 far from a net; of the others it does 2.
constexpr double kSaddleBalance = 1.5;    // negative over positive curvature
constexpr double kSaddleCurvature = 0.5;  // radians; with less, cuts find ends at the border
constexpr int kSaddlePanels = 50;
// Border over the root of the area: cuts through a longer or thinner part end at its border.
constexpr double kSaddleBorder = 7;

/// Negative and positive curvature inside a part, in radians.
struct Balance {
  double negative = 0, positive = 0;

  void add(double curvature) { (curvature > 0 ? positive : negative) += std::abs(curvature); }
  double ratio() const {
    return positive > 0 ? negative / positive : std::numeric_limits<double>::infinity();
  }
};

/// What a part and one of its neighbours would be together.
struct Joined {
  Balance inside;
  double border = 0;  ///< length between them
};

struct Choices {
  Balance own;
  std::map<int, Joined> joined;  ///< by neighbour
};

/// Parts around each vertex, ascending; those at a border of the graph get `kOutside` as well.
std::vector<std::set<int>> parts_at_vertices(const Mesh& mesh, const DualGraph& graph,
                                             const Labels& labels) {
  std::vector<std::set<int>> parts(mesh.positions.size());
  std::vector<char> is_inside(mesh.faces.size(), 0);
  for (const int face : graph.faces) is_inside[face] = 1;
  for (int panel = 0; panel < graph.panel_count(); ++panel) {
    for (const int face : graph.panel_faces(panel)) {
      for (const int v : mesh.faces[face]) parts[v].insert(labels[panel]);
      for (const int e : mesh.face_edges[face]) {
        const auto& sides = mesh.edges[e].faces;
        if (sides[1] != -1 && is_inside[sides[0]] && is_inside[sides[1]]) continue;
        for (const int v : mesh.edges[e].vertices) parts[v].insert(kOutside);
      }
    }
  }
  return parts;
}

std::map<int, Joined> neighbours_of(const DualGraph& graph, const Labels& labels, int part) {
  std::map<int, Joined> neighbours;
  for (const Hinge& hinge : graph.hinges) {
    const auto [a, b] = std::array{labels[hinge.panels[0]], labels[hinge.panels[1]]};
    if (a == b || (a != part && b != part)) continue;
    neighbours[a == part ? b : a].border += hinge.length;
  }
  return neighbours;
}

Choices choices_of(const Mesh& mesh, const DualGraph& graph, const Labels& labels, int part) {
  Choices choices{{}, neighbours_of(graph, labels, part)};
  const std::vector<double> turns = vertex_turns(mesh, graph.faces);
  const std::vector<std::set<int>> parts = parts_at_vertices(mesh, graph, labels);
  for (std::size_t v = 0; v < turns.size(); ++v) {
    if (parts[v].empty() || parts[v].contains(kOutside)) continue;
    const double curvature = 2 * std::numbers::pi - turns[v];
    if (parts[v] == std::set{part}) choices.own.add(curvature);
    for (auto& [next, joined] : choices.joined) {
      if (std::ranges::includes(std::array{std::min(part, next), std::max(part, next)}, parts[v])) {
        joined.inside.add(curvature);
      }
    }
  }
  return choices;
}

/// What decides whether a part is a saddle.
struct Shape {
  Balance inside;
  int panels = 0;
  double area = 0, border = 0;

  bool is_saddle() const {
    return panels > kSaddlePanels && inside.negative > kSaddleCurvature &&
           inside.ratio() > kSaddleBalance && border < kSaddleBorder * std::sqrt(area);
  }
};

std::vector<Shape> shapes_of(const Mesh& mesh, const DualGraph& graph, const Labels& labels) {
  const std::vector<double> areas = part_areas(graph, labels);
  std::vector<Shape> shapes(areas.size());
  for (std::size_t part = 0; part < areas.size(); ++part) shapes[part].area = areas[part];
  for (const int part : labels) ++shapes[part].panels;
  for (const Hinge& hinge : graph.hinges) {
    const auto [a, b] = std::array{labels[hinge.panels[0]], labels[hinge.panels[1]]};
    if (a == b) continue;
    for (const int part : {a, b}) shapes[part].border += hinge.length;
  }
  const std::vector<double> turns = vertex_turns(mesh, graph.faces);
  const std::vector<std::set<int>> parts = parts_at_vertices(mesh, graph, labels);
  for (std::size_t v = 0; v < turns.size(); ++v) {
    if (parts[v].size() != 1 || parts[v].contains(kOutside)) continue;
    shapes[*parts[v].begin()].inside.add(2 * std::numbers::pi - turns[v]);
  }
  return shapes;
}

/// Of the neighbours that better the balance well, the one with the longest border: cuts have to
/// pass it to where they can end. -1 when none does.
int choose_partner(const Choices& choices) {
  int partner = -1;
  for (const auto& [next, joined] : choices.joined) {
    if (joined.inside.ratio() > kBetter * choices.own.ratio()) continue;
    if (partner == -1 || joined.border > choices.joined.at(partner).border) partner = next;
  }
  return partner;
}

/// The largest part by area, but for two; -1 when no other has two panels.
int largest_but(const DualGraph& graph, const Labels& labels, int one, int other) {
  const std::vector<double> areas = part_areas(graph, labels);
  std::vector<int> sizes(areas.size(), 0);
  for (const int label : labels) ++sizes[label];
  int largest = -1;
  for (int part = 0; part < static_cast<int>(areas.size()); ++part) {
    if (part == one || part == other || sizes[part] < 2) continue;
    if (largest == -1 || areas[part] > areas[largest]) largest = part;
  }
  return largest;
}

/// Splits a part in two, with a smooth border between them; one of them becomes `second`.
void split_part(const Mesh& mesh, const DualGraph& graph, int learned_panels, Labels& labels,
                int part, int second) {
  std::vector<int> panels;
  double area = 0, all = 0;
  for (int panel = 0; panel < graph.panel_count(); ++panel) {
    all += graph.areas[panel];
    if (labels[panel] != part) continue;
    panels.push_back(panel);
    area += graph.areas[panel];
  }
  const DualGraph of_part = restrict_to(graph, panels);
  const int learned_on = std::max(1, static_cast<int>(learned_panels * area / all));
  const Labels halves =
      smooth_labels(mesh, of_part, halve(mesh, of_part), {Segmenter::kShape, learned_on});
  for (std::size_t i = 0; i < panels.size(); ++i) {
    if (halves[i] == 1) labels[panels[i]] = second;
  }
}

}  // namespace

std::optional<Regrouping> regroup(const Mesh& mesh, const DualGraph& graph, const Labels& labels,
                                  const RegroupOptions& options) {
  const int part = options.part;
  const int partner = choose_partner(choices_of(mesh, graph, labels, part));
  if (partner == -1) return std::nullopt;
  const int split = largest_but(graph, labels, part, partner);
  if (split == -1) return std::nullopt;
  Regrouping regrouping{labels, {part, partner, split}};
  std::ranges::replace(regrouping.labels, part, partner);
  split_part(mesh, graph, options.learned_panels, regrouping.labels, split, part);
  std::ranges::sort(regrouping.changed);
  return regrouping;
}

Labels regroup_saddles(const Mesh& mesh, const DualGraph& graph, int learned_panels,
                       Labels labels) {
  std::set<int> looked_at;
  while (true) {
    const std::vector<Shape> shapes = shapes_of(mesh, graph, labels);
    int saddle = -1;
    for (int part = 0; part < static_cast<int>(shapes.size()); ++part) {
      if (looked_at.contains(part) || !shapes[part].is_saddle()) continue;
      const double curvature = shapes[part].inside.negative;
      if (saddle == -1 || curvature > shapes[saddle].inside.negative) saddle = part;
    }
    if (saddle == -1) return labels;
    looked_at.insert(saddle);
    auto regrouping =
        regroup(mesh, graph, labels, {.part = saddle, .learned_panels = learned_panels});
    if (regrouping) labels = std::move(regrouping->labels);
  }
}

}  // namespace foldwright
