#include "segment/smooth_borders.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <queue>
#include <set>
#include <utility>

#include "segment/hinge_measures.h"
#include "segment/min_cut.h"

namespace foldwright {
namespace {

using Pair = std::array<int, 2>;

constexpr double kNever = std::numeric_limits<double>::infinity();

class BorderSmoother {
 public:
  BorderSmoother(const Mesh& mesh, const DualGraph& graph, Labels labels, const BorderCost& cost)
      : graph_(graph),
        labels_(std::move(labels)),
        reach_(cost.reach),
        distance_(hinge_distances(mesh, graph)) {
    const std::vector<double> bends = hinge_bends(graph, cost.convex);
    for (int h = 0; h < graph.hinge_count(); ++h) {
      price_.push_back(graph.hinges[h].length / (1 + cost.crease * bends[h]));
    }
  }

  Labels smoothed() {
    for (const auto& [pair, hinges] : borders()) smooth(pair, hinges);
    return std::move(labels_);
  }

 private:
  /// Hinges between each two neighbouring parts.
  std::map<Pair, std::vector<int>> borders() const {
    std::map<Pair, std::vector<int>> borders;
    for (int h = 0; h < graph_.hinge_count(); ++h) {
      const auto& [a, b] = graph_.hinges[h].panels;
      const auto [low, high] = std::minmax(labels_[a], labels_[b]);
      if (low != high) borders[{low, high}].push_back(h);
    }
    return borders;
  }

  bool belongs(int panel, const Pair& pair) const {
    return labels_[panel] == pair[0] || labels_[panel] == pair[1];
  }

  /// Distances of the pair's panels from the border, up to the reach; by panel.
  std::map<int, double> near(const Pair& pair, const std::vector<int>& hinges) const {
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    std::map<int, double> best;
    const auto reach = [&](int panel, double distance) {
      if (distance > reach_ || !belongs(panel, pair)) return;
      const auto [it, is_new] = best.try_emplace(panel, distance);
      if (!is_new && it->second <= distance) return;
      it->second = distance;
      open.push({distance, panel});
    };
    for (const int h : hinges) {
      for (const int panel : graph_.hinges[h].panels) reach(panel, distance_[h] / 2);
    }
    while (!open.empty()) {
      const auto [distance, panel] = open.top();
      open.pop();
      if (distance > best[panel]) continue;
      for (const int h : graph_.hinges_of(panel)) {
        reach(graph_.hinges[h].other(panel), distance + distance_[h]);
      }
    }
    return best;
  }

  void smooth(const Pair& pair, const std::vector<int>& hinges) {
    const std::map<int, double> band = near(pair, hinges);
    const Labels before = labels_;
    cut(pair, band);
    if (!mend(pair, band)) labels_ = before;
  }

  /// Labels the band by a least cut.
  void cut(const Pair& pair, const std::map<int, double>& band) {
    std::map<int, int> node;
    for (const auto& [panel, distance] : band) node.emplace(panel, static_cast<int>(node.size()));
    MinCut network(static_cast<int>(node.size()));
    const std::set<int> cores = cores_of(pair, band);
    for (const auto& [panel, distance] : band) {
      const double change =
          cores.contains(panel) ? kNever : graph_.areas[panel] * distance / reach_ / reach_;
      const bool first = labels_[panel] == pair[0];
      network.add_terminal(node.at(panel), first ? change : 0, first ? 0 : change);
      for (const int h : graph_.hinges_of(panel)) {
        const int next = graph_.hinges[h].other(panel);
        if (!belongs(next, pair)) continue;
        const auto other = node.find(next);
        if (other == node.end()) {
          const bool with_first = labels_[next] == pair[0];
          network.add_terminal(node.at(panel), with_first ? price_[h] : 0,
                               with_first ? 0 : price_[h]);
        } else if (next > panel) {
          network.add_link(node.at(panel), other->second, price_[h]);
        }
      }
    }
    const std::vector<char> with_first = network.solve();
    for (const auto& [panel, index] : node) labels_[panel] = pair[with_first[index] ? 0 : 1];
  }

  /// Of a part that lies in the band as a whole, the panel farthest from the border: it stays.
  std::set<int> cores_of(const Pair& pair, const std::map<int, double>& band) const {
    std::map<int, int> panels_in;
    for (const int label : labels_) ++panels_in[label];
    std::map<int, int> in_band, farthest;
    for (const auto& [panel, distance] : band) {
      const int part = labels_[panel];
      ++in_band[part];
      const auto [it, is_new] = farthest.try_emplace(part, panel);
      if (!is_new && distance > band.at(it->second)) it->second = panel;
    }
    std::set<int> cores;
    for (const int part : pair) {
      if (in_band[part] == panels_in[part]) cores.insert(farthest[part]);
    }
    return cores;
  }

  /// Hands what fell off one part of the pair to the other; false when a part stays in pieces.
  bool mend(const Pair& pair, const std::map<int, double>& band) {
    for (const int part : pair) {
      const std::vector<char> stray = stray_panels(part);
      for (const auto& [panel, distance] : band) {
        if (stray[panel]) labels_[panel] = pair[0] + pair[1] - part;
      }
    }
    for (const int part : pair) {
      const std::vector<char> stray = stray_panels(part);
      if (std::find(stray.begin(), stray.end(), 1) != stray.end()) return false;
    }
    return true;
  }

  /// Per panel whether it is of the part, but not of its largest piece.
  std::vector<char> stray_panels(int part) const {
    const std::vector<int> piece = part_pieces(graph_, labels_);
    std::map<int, double> area;
    for (int panel = 0; panel < graph_.panel_count(); ++panel) {
      if (labels_[panel] == part) area[piece[panel]] += graph_.areas[panel];
    }
    const auto main = std::max_element(
        area.begin(), area.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    std::vector<char> stray;
    for (int panel = 0; panel < graph_.panel_count(); ++panel) {
      stray.push_back(labels_[panel] == part && piece[panel] != main->first);
    }
    return stray;
  }

  const DualGraph& graph_;
  Labels labels_;
  double reach_;
  std::vector<double> distance_;  ///< per hinge
  std::vector<double> price_;     ///< per hinge: of a border along it
};

}  // namespace

Labels smooth_borders(const Mesh& mesh, const DualGraph& graph, Labels labels,
                      const BorderCost& cost) {
  return BorderSmoother(mesh, graph, std::move(labels), cost).smoothed();
}

}  // namespace foldwright
