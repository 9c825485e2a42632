#include "search/border_exchange.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "fold/certificate.h"
#include "mesh/connectivity.h"
#include "search/hyperbolic.h"

namespace foldwright {
namespace {

// The part is searched briefly, since most exchanges do not cure it; the neighbour, which had a net
// and nearly always still has one, as long as any search.
constexpr std::int64_t kOwnPatience = 4000;
constexpr std::int64_t kNeighbourPatience = 20000;

// Share of the draws that go to any border panel, so that every border can move in the end.
constexpr double kAnywhere = 0.2;
// Conflicts at a hyperbolic vertex are why there is no net.
constexpr double kHyperbolicWeight = 3;

/// Panels that a fold which is never to be cut holds where they are.
std::vector<char> held_panels(const DualGraph& graph) {
  std::vector<char> held(graph.panel_count(), 0);
  for (const Hinge& hinge : graph.hinges) {
    for (const int panel : hinge.panels) held[panel] |= hinge.stays_fold ? 1 : 0;
  }
  return held;
}

}  // namespace

BorderExchange::BorderExchange(const Mesh& mesh, const DualGraph& graph, PartsSoFar parts,
                               const ExchangeOptions& options)
    : mesh_(&mesh),
      graph_(&graph),
      options_(options),
      random_(options.seed),
      labels_(std::move(parts.labels)),
      vertices_of_panel_(panel_vertices(mesh, graph)),
      folds_(mesh.edges.size(), 0),
      hyperbolic_(hyperbolic_vertices(mesh)),
      held_(held_panels(graph)),
      shortfalls_(std::move(parts.shortfalls)) {
  shortfalls_.erase(options_.part);
  for (const int e : parts.fold_edges) folds_[e] = 1;
  start(own_, options_.part, kOwnPatience, 0);
}

BorderExchange::State BorderExchange::step(std::int64_t work) {
  while (state_ == State::kRunning && work > 0) {
    // Both searches of the step to their ends, then the verdict.
    TreeSearch* search = nullptr;
    for (Attempt* attempt : {&own_, &other_}) {
      const bool open = attempt->search && attempt->search->state() == TreeSearch::State::kRunning;
      if (open && search == nullptr) search = attempt->search.get();
    }
    if (search == nullptr) {
      end_step();
      if (state_ == State::kRunning) begin_step();
      continue;
    }
    const std::int64_t slice = std::min(work, kStepSlice);
    search->step(slice);
    work -= slice;
  }
  return state_;
}

double BorderExchange::progress() const {
  return std::min(1.0, static_cast<double>(steps_) / options_.most_steps);
}

std::vector<int> BorderExchange::panels_of(int part) const {
  std::vector<int> panels;
  for (int panel = 0; panel < graph_->panel_count(); ++panel) {
    if (labels_[panel] == part) panels.push_back(panel);
  }
  return panels;
}

int BorderExchange::known_shortfall(int part) const {
  const auto known = shortfalls_.find(part);
  return known == shortfalls_.end() ? 0 : known->second;
}

void BorderExchange::start(Attempt& attempt, int part, std::int64_t patience, int good_enough) {
  attempt.search.reset();
  attempt.graph = restrict_to(*graph_, panels_of(part));
  const TreeSearchOptions options = {.patience = patience,
                                     .good_enough = good_enough,
                                     .clearance = options_.clearance,
                                     .seed = random_.bits()};
  attempt.search =
      std::make_unique<TreeSearch>(*mesh_, attempt.graph, options, tree_of_folds(attempt.graph));
}

/// The known folds of a part, mended to a spanning tree where a panel came or went: nearly the tree
/// that was found before, so the search has little left to do.
FoldTree BorderExchange::tree_of_folds(const DualGraph& graph) {
  std::vector<double> weights;
  for (const Hinge& hinge : graph.hinges) {
    weights.push_back(folds_[hinge.edges[0]] ? 0 : 1 + random_.uniform());
  }
  return minimum_spanning_tree(graph, weights);
}

void BorderExchange::remember_folds(const Attempt& attempt) {
  for (const Hinge& hinge : attempt.graph.hinges) folds_[hinge.edges[0]] = 0;
  for (const int h : attempt.search->best()) folds_[attempt.graph.hinges[h].edges[0]] = 1;
}

/// Per panel: how much the part's best tree is in conflict at the panel's vertices.
std::vector<double> BorderExchange::weigh_panels() const {
  const std::vector<int> panels = panels_of(options_.part);
  std::map<int, double> at_vertex;
  for (const auto& pair : own_.search->conflicts()) {
    for (const int panel : pair) {
      for (const int v : vertices_of_panel_[panels[panel]]) {
        at_vertex[v] += hyperbolic_[v] ? kHyperbolicWeight : 1;
      }
    }
  }
  std::vector<double> weights(graph_->panel_count(), 0);
  for (int panel = 0; panel < graph_->panel_count(); ++panel) {
    for (const int v : vertices_of_panel_[panel]) {
      const auto found = at_vertex.find(v);
      if (found != at_vertex.end()) weights[panel] += found->second;
    }
  }
  return weights;
}

/// Draws a border panel by weight: one of the part's own to give, or a neighbour's to take.
BorderExchange::Exchange BorderExchange::choose() {
  std::set<std::pair<int, int>> candidates;  // panel, part it would go to
  for (const Hinge& hinge : graph_->hinges) {
    for (const int side : {0, 1}) {
      const int panel = hinge.panels[side];
      const int to = labels_[hinge.panels[1 - side]];
      if (labels_[panel] == to || held_[panel]) continue;
      if (labels_[panel] == options_.part || to == options_.part) candidates.insert({panel, to});
    }
  }
  while (!candidates.empty()) {
    double sum = 0;
    for (const auto& [panel, to] : candidates) sum += weights_[panel];
    const bool anywhere = random_.uniform() < kAnywhere || sum == 0;
    if (anywhere) sum = static_cast<double>(candidates.size());
    double left = random_.uniform() * sum;
    auto chosen = candidates.begin();
    for (; std::next(chosen) != candidates.end(); ++chosen) {
      left -= anywhere ? 1 : weights_[chosen->first];
      if (left < 0) break;
    }
    if (stays_connected(*graph_, labels_, chosen->first)) return {chosen->first, chosen->second};
    candidates.erase(chosen);
  }
  return {};
}

void BorderExchange::begin_step() {
  const bool may_go_on = steps_++ < options_.most_steps && moves_ < options_.most_moves;
  exchange_ = may_go_on ? choose() : Exchange{};
  if (exchange_.panel == -1) {
    state_ = State::kGaveUp;
    return;
  }
  const int from = labels_[exchange_.panel];
  neighbour_ = from == options_.part ? exchange_.to : from;
  labels_[exchange_.panel] = exchange_.to;
  exchange_.to = from;  // what undoing needs
  start(own_, options_.part, kOwnPatience, 0);
  start(other_, neighbour_, kNeighbourPatience, known_shortfall(neighbour_));
}

void BorderExchange::end_step() {
  moves_ += own_.search->moves() + (other_.search ? other_.search->moves() : 0);
  const int own = own_.search->shortfall();
  bool keep = true;
  if (other_.search) {
    const int known = known_shortfall(neighbour_);
    const int other = other_.search->shortfall();
    const int added = own + other - shortfall_ - known;
    keep = other <= known &&
           (added <= 0 || random_.uniform() < std::exp(-added / options_.temperature));
    if (keep) {
      if (known > 0) shortfalls_[neighbour_] = other;
      if (other == 0) shortfalls_.erase(neighbour_);
      trees_[neighbour_] = other_.search->best();
      remember_folds(other_);
    } else {
      labels_[exchange_.panel] = exchange_.to;
    }
  }
  if (!keep) return;
  shortfall_ = own;
  weights_ = weigh_panels();
  trees_[options_.part] = own_.search->best();
  remember_folds(own_);
  if (own == 0) state_ = State::kFound;
}

}  // namespace foldwright
