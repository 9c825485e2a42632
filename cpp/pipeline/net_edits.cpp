#include "pipeline/net_edits.h"

#include <algorithm>
#include <set>
#include <utility>

#include "mesh/connectivity.h"
#include "mesh/input_error.h"
#include "pipeline/edits.h"
#include "pipeline/net_split.h"
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
    const auto& [a, b] = edge.vertices;
    return (a == name.from && b == name.to) || (a == name.to && b == name.from);
  };
  const auto found = std::ranges::find_if(mesh.edges, is_it);
  if (found == mesh.edges.end()) {
    throw InputError("no-edge", {{"from", name.from}, {"to", name.to}});
  }
  return static_cast<int>(found - mesh.edges.begin());
}

/// The hinge that an edge lies on, of the model's graph.
int hinge_at(const Surface& surface, const EdgeName& name) {
  const int edge = edge_at(surface.mesh, name);
  if (surface.mesh.edges[edge].faces[1] == -1) {
    throw InputError("open-border", {{"what", "edge"}});
  }
  const auto& hinges = surface.graph.hinges;
  const auto found = std::ranges::find_if(
      hinges, [&](const Hinge& hinge) { return std::ranges::binary_search(hinge.edges, edge); });
  if (found == hinges.end()) {
    throw InputError("inside-panel");
  }
  return static_cast<int>(found - hinges.begin());
}

/// The net that has a face. \throw InputError if none has
std::size_t net_of(const EarlierNets& nets, int face) {
  const auto found = std::ranges::find_if(
      nets.nets, [&](const SavedNet& net) { return std::ranges::binary_search(net.faces, face); });
  if (found == nets.nets.end()) {
    throw InputError("no-net", Parameters{}, {face});
  }
  return static_cast<std::size_t>(found - nets.nets.begin());
}

class NetEditor {
 public:
  NetEditor(const Surface& surface, double scale, EarlierNets& nets)
      : surface_(surface), graph_(surface.graph), scale_(scale), nets_(nets) {}

  std::optional<PartEdit> operator()(const CutEdit& edit) {
    const Hinge& hinge = graph_.hinges[hinge_at(surface_, edit.edge)];
    const std::size_t i = net_of(nets_, graph_.panel_faces(hinge.panels[0])[0]);
    const std::vector<int>& folds = nets_.nets[i].folds;
    const auto fold = std::ranges::find(folds, hinge.edges[0]);
    if (fold == folds.end()) throw InputError("already-cut");
    const LoadedNet whole = load(graph_, nets_.nets[i]);
    std::vector<SavedNet> halves;
    for (const FoundNet& half :
         split_net(whole.component, whole.net, static_cast<int>(fold - folds.begin()))) {
      SavedNet& saved = halves.emplace_back(save_net(whole.component, half));
      saved.cause = Cause::kEdit;
      keep_place(surface_, scale_, whole, saved);
    }
    nets_.nets[i] = std::move(halves[0]);
    nets_.nets.push_back(std::move(halves[1]));
    return std::nullopt;
  }

  std::optional<PartEdit> operator()(const JoinEdit& edit) {
    const int hinge = hinge_at(surface_, edit.edge);
    const auto& [a, b] = graph_.hinges[hinge].panels;
    const std::size_t i = net_of(nets_, graph_.panel_faces(a)[0]);
    const std::size_t j = net_of(nets_, graph_.panel_faces(b)[0]);
    if (i == j) {
      reopen(i, hinge, edit.open);
      return std::nullopt;
    }
    return join(i, j, hinge, edit.search);
  }

  std::optional<PartEdit> operator()(const AssignEdit& edit) {
    if (edit.part < 0 || edit.part >= nets_.part_count) {
      throw InputError("no-part", {{"part", edit.part + 1}, {"parts", nets_.part_count}});
    }
    std::vector<int> labels = nets_.labels;
    std::set<int> donors;
    for (const int panel : panels_with(edit.faces)) {
      for (const int face : graph_.panel_faces(panel)) {
        if (labels[face] != edit.part) donors.insert(labels[face]);
        labels[face] = edit.part;
      }
    }
    check_connected(labels, edit.part, "not-touching");
    std::optional<PartEdit> emptied;
    for (const int donor : donors) {
      if (std::ranges::count(labels, donor) > 0) {
        check_connected(labels, donor, "would-fall-apart");
      } else if (!emptied) {
        emptied = {{edit.part, donor}, 1};
      } else {
        emptied->parts.push_back(donor);
      }
    }
    std::erase_if(nets_.nets, [&](const SavedNet& net) {
      const auto is_moved = [&](int face) { return labels[face] != nets_.labels[face]; };
      return net.part == edit.part || std::ranges::any_of(net.faces, is_moved);
    });
    nets_.labels = std::move(labels);
    if (emptied) renumber(*emptied);
    return emptied;
  }

 private:
  /// The net over some panels, folded along some hinges of the model's graph; without a motion.
  SavedNet make_saved(int part, std::span<const int> panels, std::vector<int> hinges) const {
    SavedNet saved{part, Cause::kEdit, {}, {}, {}};
    for (const int panel : panels) {
      const auto faces = graph_.panel_faces(panel);
      saved.faces.insert(saved.faces.end(), faces.begin(), faces.end());
    }
    std::ranges::sort(saved.faces);
    std::ranges::sort(hinges);
    for (const int h : hinges) saved.folds.push_back(graph_.hinges[h].edges[0]);
    return saved;
  }

  /// Faces of a net that overlap others, ascending.
  std::vector<int> overlapping_faces(const SavedNet& saved) const {
    const LoadedNet loaded = load(graph_, saved);
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

  /// Panels of the model that a net has, and its folds as hinges of the model.
  struct Tree {
    std::vector<int> panels, hinges;
  };
  Tree tree_of(const SavedNet& net) const {
    const LoadedNet loaded = load(graph_, net);
    Tree tree{loaded.component.panels, {}};
    const std::map<int, int> hinge_of = hinges_by_edge(graph_);
    for (const int edge : net.folds) tree.hinges.push_back(hinge_of.at(edge));
    return tree;
  }

  /// Makes one net of two.
  std::optional<PartEdit> join(std::size_t i, std::size_t j, int hinge, bool search) {
    if (nets_.nets[j].faces.size() > nets_.nets[i].faces.size()) std::swap(i, j);
    Tree tree = tree_of(nets_.nets[i]);
    const Tree other = tree_of(nets_.nets[j]);
    tree.panels.insert(tree.panels.end(), other.panels.begin(), other.panels.end());
    tree.hinges.insert(tree.hinges.end(), other.hinges.begin(), other.hinges.end());
    tree.hinges.push_back(hinge);
    std::ranges::sort(tree.panels);
    SavedNet joined = make_saved(nets_.nets[i].part, tree.panels, tree.hinges);
    const std::vector<int> faces = overlapping_faces(joined);
    if (!faces.empty() && !search) {
      throw InputError("overlap", {{"what", "pieces"}}, faces);
    }
    if (faces.empty()) keep_place(surface_, scale_, load(graph_, nets_.nets[i]), joined);
    const int part = nets_.nets[i].part;
    const int emptied = nets_.nets[j].part;
    nets_.nets[i] = std::move(joined);
    if (!faces.empty()) nets_.nets[i].faces.clear();
    nets_.nets[j].faces.clear();
    std::erase_if(nets_.nets, [](const SavedNet& net) { return net.faces.empty(); });
    if (part == emptied) {
      name_whole_part(part);
      return std::nullopt;
    }
    const PartEdit merged{{part, emptied}, 1};
    const int number = renumber(merged);
    name_whole_part(number);
    return merged;
  }

  /// A part that is in one piece again needs no reason.
  void name_whole_part(int part) {
    const auto is_of = [&](const SavedNet& net) { return net.part == part; };
    if (std::ranges::count_if(nets_.nets, is_of) != 1) return;
    SavedNet& net = *std::ranges::find_if(nets_.nets, is_of);
    const auto faces = std::ranges::count(nets_.labels, part);
    if (faces == static_cast<std::ptrdiff_t>(net.faces.size())) net.cause = Cause::kPart;
  }

  /// Joins along a hinge within a net, and opens the loop elsewhere.
  void reopen(std::size_t i, int hinge, const std::optional<EdgeName>& open) {
    const Tree tree = tree_of(nets_.nets[i]);
    if (std::ranges::count(tree.hinges, hinge) > 0) {
      throw InputError("already-joined");
    }
    std::vector<int> loop = loop_of(tree, hinge);
    if (open) {
      const int wanted = hinge_at(surface_, *open);
      if (std::ranges::count(loop, wanted) == 0) {
        throw InputError("not-in-loop");
      }
      loop = {wanted};
    }
    // Least to glue first.
    std::ranges::sort(loop, {}, [&](int h) { return std::pair(graph_.hinges[h].length, h); });
    std::vector<int> in_the_way;
    for (const int opened : loop) {
      std::vector<int> hinges = tree.hinges;
      std::erase(hinges, opened);
      hinges.push_back(hinge);
      SavedNet saved = make_saved(nets_.nets[i].part, tree.panels, hinges);
      saved.cause = nets_.nets[i].cause;
      std::vector<int> faces = overlapping_faces(saved);
      if (faces.empty()) {
        keep_place(surface_, scale_, load(graph_, nets_.nets[i]), saved);
        nets_.nets[i] = std::move(saved);
        return;
      }
      if (in_the_way.empty() || faces.size() < in_the_way.size()) in_the_way = std::move(faces);
    }
    throw InputError("overlap", {{"what", "loop"}}, in_the_way);
  }

  /// Folds of a tree on the way between the panels of a hinge.
  std::vector<int> loop_of(const Tree& tree, int hinge) const {
    std::map<int, std::vector<int>> hinges_at;
    for (const int h : tree.hinges) {
      for (const int panel : graph_.hinges[h].panels) hinges_at[panel].push_back(h);
    }
    const auto& [from, to] = graph_.hinges[hinge].panels;
    std::map<int, int> reached_by = {{from, -1}};
    std::vector<int> open = {from};
    for (std::size_t next = 0; next < open.size(); ++next) {
      for (const int h : hinges_at[open[next]]) {
        const int panel = graph_.hinges[h].other(open[next]);
        if (reached_by.emplace(panel, h).second) open.push_back(panel);
      }
    }
    std::vector<int> loop;
    for (int panel = to; panel != from; panel = graph_.hinges[loop.back()].other(panel)) {
      loop.push_back(reached_by.at(panel));
    }
    return loop;
  }

  std::vector<int> panels_with(std::span<const int> faces) const {
    const std::set<int> wanted(faces.begin(), faces.end());
    if (wanted.empty()) throw InputError("no-face", {{"what", "none"}});
    const int count = static_cast<int>(nets_.labels.size());
    if (*wanted.begin() < 0 || *wanted.rbegin() >= count) {
      throw InputError("no-face", {{"what", "beyond"}, {"most", count - 1}});
    }
    std::vector<int> panels;
    for (int panel = 0; panel < graph_.panel_count(); ++panel) {
      const auto of = graph_.panel_faces(panel);
      if (std::ranges::any_of(of, [&](int face) { return wanted.contains(face); })) {
        panels.push_back(panel);
      }
    }
    return panels;
  }

  void check_connected(const std::vector<int>& labels, int part, Code if_not) const {
    std::vector<int> panels;
    for (int panel = 0; panel < graph_.panel_count(); ++panel) {
      if (labels[graph_.panel_faces(panel)[0]] == part) panels.push_back(panel);
    }
    if (!is_connected(restrict_to(graph_, panels))) throw InputError(if_not, {{"part", part + 1}});
  }

  /// Gives parts their numbers after a merge, and returns that of what is merged.
  int renumber(const PartEdit& merged) {
    const EditedNumbers numbers = number_parts(nets_.part_count, std::span(&merged, 1));
    const auto number = [&](int part) {
      return numbers.of_part[part] == -1 ? numbers.of_edit[0][0] : numbers.of_part[part];
    };
    for (int& label : nets_.labels) label = number(label);
    for (SavedNet& net : nets_.nets) net.part = number(net.part);
    nets_.part_count = numbers.count;
    return numbers.of_edit[0][0];
  }

  const Surface& surface_;
  const DualGraph& graph_;
  double scale_;
  EarlierNets& nets_;
};

}  // namespace

std::optional<PartEdit> apply_net_edit(const Surface& surface, double scale, const NetEdit& edit,
                                       EarlierNets& nets) {
  return std::visit(NetEditor(surface, scale, nets), edit);
}

}  // namespace foldwright
