#include "pipeline/nets/net_trees.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "mesh/input_error.h"
#include "pipeline/nets/net_split.h"
#include "pipeline/saved_net.h"

namespace foldwright {
namespace {

/// A net of the earlier result on a graph of its own panels.
struct LoadedNet {
  Component component;
  FoundNet net;
};

LoadedNet load(const DualGraph& graph, const SavedNet& saved) {
  std::vector<int> panels;
  for (int panel = 0; panel < graph.panel_count(); ++panel) {
    if (std::ranges::binary_search(saved.faces, graph.panel_faces(panel)[0])) {
      panels.push_back(panel);
    }
  }
  LoadedNet loaded{make_component(graph, std::move(panels)), {}};
  loaded.net = load_net(loaded.component, 0, saved);
  return loaded;
}

/// The motion between the flat copies of two nets that share a face: from the first's to the
/// second's, in model units. \pre they have a face in common
RigidMotion2 motion_between(const Net& from, const Net& to) {
  for (std::size_t i = 0; i < from.faces.size(); ++i) {
    const auto found = std::ranges::lower_bound(to.faces, from.faces[i]);
    if (found == to.faces.end() || *found != from.faces[i]) continue;
    const auto& [a, b, c] = from.corners[i];
    const auto& [p, q, r] = to.corners[found - to.faces.begin()];
    return motion_onto(from.vertices[a], from.vertices[b], to.vertices[p], to.vertices[q]);
  }
  return {};
}

Net flat(const Mesh& mesh, const LoadedNet& loaded) {
  return make_net(mesh, restrict_to(loaded.component.graph, loaded.net.region.panels),
                  loaded.net.folds);
}

/// Keeps the faces that a net has in common with one before where they lay.
void keep_place(const Surface& surface, double scale, const LoadedNet& before, SavedNet& after) {
  if (!before.net.place) return;
  const Net now = flat(surface.mesh, load(surface.graph, after));
  RigidMotion2 motion = motion_between(now, flat(surface.mesh, before));
  motion.t *= scale;
  after.place = {before.net.place->sheet, before.net.place->motion * motion};
}

/// Number of the mesh edge. \throw InputError if there is none
int edge_at(const Mesh& mesh, const EdgeName& name) {
  const auto is_it = [&](const Mesh::Edge& edge) {
    return is_same_edge({edge.vertices[0], edge.vertices[1]}, name);
  };
  const auto found = std::ranges::find_if(mesh.edges, is_it);
  if (found == mesh.edges.end()) {
    throw InputError("no-edge", {{"from", name.from}, {"to", name.to}});
  }
  return static_cast<int>(found - mesh.edges.begin());
}

/// The net that a tree makes; without a motion, as an edit made it.
SavedNet make_saved(const DualGraph& graph, int part, const NetTrees::Tree& tree) {
  SavedNet saved{part, Cause::kEdit, {}, {}, {}};
  for (const int panel : tree.panels) {
    const auto faces = graph.panel_faces(panel);
    saved.faces.insert(saved.faces.end(), faces.begin(), faces.end());
  }
  std::ranges::sort(saved.faces);
  std::vector<int> hinges = tree.hinges;
  std::ranges::sort(hinges);
  for (const int h : hinges) saved.folds.push_back(graph.hinges[h].edges[0]);
  return saved;
}

/// Faces of a net that overlap others, ascending.
std::vector<int> overlapping_faces(const DualGraph& whole, const SavedNet& saved) {
  const LoadedNet loaded = load(whole, saved);
  const DualGraph& graph = loaded.component.graph;
  const Layout layout = lay_out(graph, hang_tree(graph, loaded.net.folds));
  std::set<int> faces;
  for (const auto& pair : overlapping_panels(graph, layout)) {
    for (const int panel : pair) {
      const auto of = graph.panel_faces(panel);
      faces.insert(of.begin(), of.end());
    }
  }
  return {faces.begin(), faces.end()};
}

/// The folds of a tree at each panel.
std::map<int, std::vector<int>> folds_by_panel(const DualGraph& graph, std::span<const int> folds) {
  std::map<int, std::vector<int>> by_panel;
  for (const int h : folds) {
    for (const int panel : graph.hinges[h].panels) by_panel[panel].push_back(h);
  }
  return by_panel;
}

/// Panels that are reached from one over folds, each with the fold that it is reached by; -1 for
/// the first.
std::map<int, int> reach(const DualGraph& graph, std::span<const int> folds, int from) {
  const std::map<int, std::vector<int>> folds_at = folds_by_panel(graph, folds);
  std::map<int, int> reached_by = {{from, -1}};
  std::vector<int> open = {from};
  for (std::size_t next = 0; next < open.size(); ++next) {
    const auto found = folds_at.find(open[next]);
    if (found == folds_at.end()) continue;
    for (const int h : found->second) {
      const int panel = graph.hinges[h].other(open[next]);
      if (reached_by.emplace(panel, h).second) open.push_back(panel);
    }
  }
  return reached_by;
}

}  // namespace

bool is_same_edge(const EdgeName& a, const EdgeName& b) {
  return (a.from == b.from && a.to == b.to) || (a.from == b.to && a.to == b.from);
}

int NetTrees::hinge_at(const EdgeName& name) const {
  const int edge = edge_at(surface_.mesh, name);
  if (surface_.mesh.edges[edge].faces[1] == -1) {
    throw InputError("open-border", {{"what", "edge"}});
  }
  const auto found = std::ranges::find_if(graph_.hinges, [&](const Hinge& hinge) {
    return std::ranges::binary_search(hinge.edges, edge);
  });
  if (found != graph_.hinges.end()) return static_cast<int>(found - graph_.hinges.begin());
  const auto is_locked = [&](const EdgeLock& lock) {
    return !lock.is_fold && is_same_edge({lock.vertices[0], lock.vertices[1]}, name);
  };
  if (std::ranges::any_of(surface_.locks, is_locked)) {
    throw InputError("locked", {{"what", "cut"}});
  }
  throw InputError("inside-panel");
}

std::size_t NetTrees::net_at(int hinge, int side) const {
  const int face = graph_.panel_faces(graph_.hinges[hinge].panels[side])[0];
  const auto found = std::ranges::find_if(
      nets_.nets, [&](const SavedNet& net) { return std::ranges::binary_search(net.faces, face); });
  if (found == nets_.nets.end()) {
    throw InputError("no-net", Parameters{}, {face});
  }
  return static_cast<std::size_t>(found - nets_.nets.begin());
}

bool NetTrees::folds_at(int hinge) const {
  return std::ranges::count(nets_.nets[net_at(hinge, 0)].folds, graph_.hinges[hinge].edges[0]) > 0;
}

NetTrees::Tree NetTrees::tree_of(std::size_t net) const {
  const LoadedNet loaded = load(graph_, nets_.nets[net]);
  Tree tree{loaded.component.panels, {}};
  const std::map<int, int> hinge_of = hinges_by_edge(graph_);
  for (const int edge : nets_.nets[net].folds) tree.hinges.push_back(hinge_of.at(edge));
  return tree;
}

std::vector<int> NetTrees::loop_of(const Tree& tree, int hinge) const {
  const auto& [from, to] = graph_.hinges[hinge].panels;
  const std::map<int, int> reached_by = reach(graph_, tree.hinges, from);
  std::vector<int> loop;
  for (int panel = to; panel != from; panel = graph_.hinges[loop.back()].other(panel)) {
    loop.push_back(reached_by.at(panel));
  }
  return loop;
}

std::vector<int> NetTrees::hinges_across(const Tree& tree, int fold) const {
  std::vector<int> folds = tree.hinges;
  std::erase(folds, fold);
  const std::map<int, int> side = reach(graph_, folds, graph_.hinges[fold].panels[0]);
  std::vector<int> across;
  for (const auto& [panel, reached_by] : side) {
    for (const int h : graph_.hinges_of(panel)) {
      const int beyond = graph_.hinges[h].other(panel);
      const bool is_of_net = std::ranges::binary_search(tree.panels, beyond);
      if (h != fold && is_of_net && !side.contains(beyond)) across.push_back(h);
    }
  }
  return across;
}

void NetTrees::cut(std::size_t net, int hinge) {
  const LoadedNet whole = load(graph_, nets_.nets[net]);
  const std::vector<int>& folds = nets_.nets[net].folds;
  const auto fold = std::ranges::find(folds, graph_.hinges[hinge].edges[0]) - folds.begin();
  std::vector<SavedNet> halves;
  for (const FoundNet& half : split_net(whole.component, whole.net, static_cast<int>(fold))) {
    SavedNet& saved = halves.emplace_back(save_net(whole.component, half));
    saved.cause = Cause::kEdit;
    keep_place(surface_, scale_, whole, saved);
  }
  nets_.nets[net] = std::move(halves[0]);
  nets_.nets.push_back(std::move(halves[1]));
}

std::vector<int> NetTrees::replace(std::size_t net, const Tree& tree) {
  SavedNet& before = nets_.nets[net];
  SavedNet saved = make_saved(graph_, before.part, tree);
  if (saved.faces.size() == before.faces.size()) saved.cause = before.cause;
  std::vector<int> faces = overlapping_faces(graph_, saved);
  if (faces.empty()) {
    keep_place(surface_, scale_, load(graph_, before), saved);
    before = std::move(saved);
  }
  return faces;
}

}  // namespace foldwright
