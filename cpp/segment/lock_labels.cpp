#include "segment/lock_labels.h"

#include <algorithm>
#include <map>
#include <utility>

#include "geometry/union_find.h"

namespace foldwright {
namespace {

/// Gives each group the label that has most of its area.
void unite_groups(const DualGraph& graph, const std::vector<int>& groups, Labels& labels) {
  std::map<int, std::map<int, double>> areas;  // group -> label -> area
  for (int panel = 0; panel < graph.panel_count(); ++panel) {
    areas[groups[panel]][labels[panel]] += graph.areas[panel];
  }
  for (int panel = 0; panel < graph.panel_count(); ++panel) {
    const auto& of = areas.at(groups[panel]);
    labels[panel] =
        std::ranges::max_element(of, {}, [](const auto& entry) { return entry.second; })->first;
  }
}

/// The smallest piece of a part that is in several, by `part_pieces`; -1 if there is none.
int stray_piece(const DualGraph& graph, const Labels& labels, const std::vector<int>& pieces) {
  std::vector<double> areas(part_count(pieces), 0);
  std::map<int, int> largest;  // part -> its largest piece
  for (int panel = 0; panel < graph.panel_count(); ++panel) {
    areas[pieces[panel]] += graph.areas[panel];
  }
  for (int panel = 0; panel < graph.panel_count(); ++panel) {
    int& piece = largest.try_emplace(labels[panel], pieces[panel]).first->second;
    if (areas[pieces[panel]] > areas[piece]) piece = pieces[panel];
  }
  int stray = -1;
  for (int panel = 0; panel < graph.panel_count(); ++panel) {
    const int piece = pieces[panel];
    if (piece == largest.at(labels[panel])) continue;
    if (stray == -1 || areas[piece] < areas[stray]) stray = piece;
  }
  return stray;
}

/// The label with the longest border to a piece. \pre the graph is connected
int longest_neighbour(const DualGraph& graph, const Labels& labels, const std::vector<int>& pieces,
                      int piece) {
  std::map<int, double> borders;
  for (const Hinge& hinge : graph.hinges) {
    const auto& [a, b] = hinge.panels;
    if (pieces[a] == pieces[b]) continue;
    if (pieces[a] == piece) borders[labels[b]] += hinge.length;
    if (pieces[b] == piece) borders[labels[a]] += hinge.length;
  }
  return std::ranges::max_element(borders, {}, [](const auto& entry) { return entry.second; })
      ->first;
}

}  // namespace

std::vector<int> locked_groups(const DualGraph& graph) {
  UnionFind sets(graph.panel_count());
  for (const Hinge& hinge : graph.hinges) {
    if (hinge.stays_fold) sets.join(hinge.panels[0], hinge.panels[1]);
  }
  std::vector<int> groups;
  for (int panel = 0; panel < graph.panel_count(); ++panel) groups.push_back(sets.find(panel));
  return groups;
}

bool is_held_together(const DualGraph& graph) {
  const std::vector<int> groups = locked_groups(graph);
  return std::ranges::count(groups, 0) == graph.panel_count();
}

Labels keep_locked_together(const DualGraph& graph, Labels labels) {
  if (std::ranges::none_of(graph.hinges, &Hinge::stays_fold)) return labels;
  const int count = part_count(labels);
  unite_groups(graph, locked_groups(graph), labels);
  for (;;) {
    const std::vector<int> pieces = part_pieces(graph, labels);
    const int stray = stray_piece(graph, labels, pieces);
    if (stray == -1) break;
    const int label = longest_neighbour(graph, labels, pieces, stray);
    for (int panel = 0; panel < graph.panel_count(); ++panel) {
      if (pieces[panel] == stray) labels[panel] = label;
    }
  }
  Labels without_gaps = renumbered(labels);
  return part_count(without_gaps) == count ? labels : without_gaps;
}

Labels halve_between_locks(const DualGraph& graph, Labels labels) {
  labels = keep_locked_together(graph, std::move(labels));
  if (std::ranges::count(labels, labels[0]) < static_cast<std::ptrdiff_t>(labels.size())) {
    return labels;
  }
  // The group that comes last on the way through all of them leaves the others connected.
  const std::vector<int> groups = locked_groups(graph);
  std::vector<int> order = {groups[0]};
  std::vector<char> is_reached(labels.size(), 0);
  is_reached[groups[0]] = 1;
  for (std::size_t next = 0; next < order.size(); ++next) {
    for (const Hinge& hinge : graph.hinges) {
      for (const int side : {0, 1}) {
        if (groups[hinge.panels[side]] != order[next]) continue;
        const int beyond = groups[hinge.panels[1 - side]];
        if (!std::exchange(is_reached[beyond], 1)) order.push_back(beyond);
      }
    }
  }
  for (std::size_t panel = 0; panel < labels.size(); ++panel) {
    labels[panel] = groups[panel] == order.back() ? 1 : 0;
  }
  return labels;
}

}  // namespace foldwright
