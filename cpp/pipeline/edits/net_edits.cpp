#include "pipeline/edits/net_edits.h"

#include <algorithm>
#include <set>
#include <utility>

#include "mesh/connectivity.h"
#include "mesh/input_error.h"
#include "pipeline/edits/edits.h"

namespace foldwright {
namespace {

using Tree = NetTrees::Tree;

/// A tree with one fold for another.
Tree swapped(Tree tree, int cut, int join) {
  std::erase(tree.hinges, cut);
  tree.hinges.push_back(join);
  return tree;
}

class NetEditor {
 public:
  NetEditor(const Surface& surface, double scale, EarlierNets& nets)
      : surface_(surface), graph_(surface.graph), nets_(nets), trees_(surface, scale, nets) {}

  std::optional<PartEdit> operator()(const CutEdit& edit) {
    const int hinge = trees_.hinge_at(edit.edge);
    if (!trees_.folds_at(hinge)) throw InputError("already-cut");
    if (graph_.hinges[hinge].stays_fold) throw InputError("locked", {{"what", "fold"}});
    trees_.cut(trees_.net_at(hinge, 0), hinge);
    return std::nullopt;
  }

  std::optional<PartEdit> operator()(const JoinEdit& edit) {
    const int hinge = trees_.hinge_at(edit.edge);
    const std::size_t i = trees_.net_at(hinge, 0);
    const std::size_t j = trees_.net_at(hinge, 1);
    if (i == j) {
      reopen(i, hinge, edit.open);
      return std::nullopt;
    }
    return join(i, j, hinge, edit.search);
  }

  std::optional<PartEdit> operator()(const LockEdit& edit) {
    const int hinge = trees_.hinge_at(edit.edge);
    const bool is_fold = trees_.folds_at(hinge);
    if (edit.as == LockKind::kFold && !is_fold) return (*this)(JoinEdit{edit.edge});
    if (edit.as == LockKind::kCut) {
      check_connected_without(hinge);
      if (is_fold) open(hinge);
    }
    return std::nullopt;
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
    check_locks(labels);
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
  /// Cuts a fold, and joins the two sides where that leaves least to glue; if faces overlap
  /// wherever that is, the net falls in two.
  void open(int hinge) {
    const std::size_t i = trees_.net_at(hinge, 0);
    const Tree tree = trees_.tree_of(i);
    std::vector<int> ways = trees_.hinges_across(tree, hinge);
    std::ranges::sort(ways, {}, [&](int h) { return std::pair(-graph_.hinges[h].length, h); });
    for (const int way : ways) {
      if (trees_.replace(i, swapped(tree, hinge, way)).empty()) return;
    }
    trees_.cut(i, hinge);
  }

  /// Parts must not hang together by what is never to be a fold alone.
  void check_connected_without(int hinge) const {
    const auto& [a, b] = graph_.hinges[hinge].panels;
    const int part = nets_.labels[graph_.panel_faces(a)[0]];
    if (nets_.labels[graph_.panel_faces(b)[0]] != part) return;
    const auto& [v, w] = surface_.mesh.edges[graph_.hinges[hinge].edges[0]].vertices;
    const EdgeLock lock = {{v, w}, false};
    const DualGraph without = lock_edges(surface_.mesh, graph_, std::span(&lock, 1));
    if (is_connected(restrict_to(without, panels_of(nets_.labels, part)))) return;
    throw InputError("would-fall-apart", {{"what", "fold"}, {"part", part + 1}});
  }

  /// Folds that are never to be cut lie within parts.
  void check_locks(const std::vector<int>& labels) const {
    for (const Hinge& hinge : graph_.hinges) {
      const int a = graph_.panel_faces(hinge.panels[0])[0];
      const int b = graph_.panel_faces(hinge.panels[1])[0];
      if (!hinge.stays_fold || labels[a] == labels[b]) continue;
      throw InputError("locked", {{"what", "faces"}}, {a, b});
    }
  }

  /// Makes one net of two.
  std::optional<PartEdit> join(std::size_t i, std::size_t j, int hinge, bool search) {
    if (nets_.nets[j].faces.size() > nets_.nets[i].faces.size()) std::swap(i, j);
    Tree tree = trees_.tree_of(i);
    const Tree other = trees_.tree_of(j);
    tree.panels.insert(tree.panels.end(), other.panels.begin(), other.panels.end());
    tree.hinges.insert(tree.hinges.end(), other.hinges.begin(), other.hinges.end());
    tree.hinges.push_back(hinge);
    std::ranges::sort(tree.panels);
    const int part = nets_.nets[i].part;
    const int emptied = nets_.nets[j].part;
    const std::vector<int> faces = trees_.replace(i, tree);
    if (!faces.empty() && !search) {
      throw InputError("overlap", {{"what", "pieces"}}, faces);
    }
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
    const Tree tree = trees_.tree_of(i);
    if (std::ranges::count(tree.hinges, hinge) > 0) {
      throw InputError("already-joined");
    }
    std::vector<int> loop = trees_.loop_of(tree, hinge);
    if (open) {
      const int wanted = trees_.hinge_at(*open);
      if (std::ranges::count(loop, wanted) == 0) {
        throw InputError("not-in-loop");
      }
      loop = {wanted};
    }
    std::erase_if(loop, [&](int h) { return graph_.hinges[h].stays_fold; });
    if (loop.empty()) {
      throw InputError("locked", {{"what", "loop"}});
    }
    // Least to glue first.
    std::ranges::sort(loop, {}, [&](int h) { return std::pair(graph_.hinges[h].length, h); });
    std::vector<int> in_the_way;
    for (const int opened : loop) {
      std::vector<int> faces = trees_.replace(i, swapped(tree, opened, hinge));
      if (faces.empty()) return;
      if (in_the_way.empty() || faces.size() < in_the_way.size()) in_the_way = std::move(faces);
    }
    throw InputError("overlap", {{"what", "loop"}}, in_the_way);
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

  /// Panels of a part, by labels of faces; ascending.
  std::vector<int> panels_of(const std::vector<int>& labels, int part) const {
    std::vector<int> panels;
    for (int panel = 0; panel < graph_.panel_count(); ++panel) {
      if (labels[graph_.panel_faces(panel)[0]] == part) panels.push_back(panel);
    }
    return panels;
  }

  void check_connected(const std::vector<int>& labels, int part, Code if_not) const {
    if (is_connected(restrict_to(graph_, panels_of(labels, part)))) return;
    throw InputError(if_not, {{"what", "faces"}, {"part", part + 1}});
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
  EarlierNets& nets_;
  NetTrees trees_;
};

}  // namespace

std::vector<EdgeLock> locks_before(std::span<const EdgeLock> locks,
                                   std::span<const NetEdit> edits) {
  std::vector<EdgeLock> before(locks.begin(), locks.end());
  for (const NetEdit& edit : edits) {
    const auto* locking = std::get_if<LockEdit>(&edit);
    if (locking == nullptr) continue;
    std::erase_if(before, [&](const EdgeLock& lock) {
      return is_same_edge({lock.vertices[0], lock.vertices[1]}, locking->edge);
    });
  }
  return before;
}

std::optional<PartEdit> apply_net_edit(const Surface& surface, double scale, const NetEdit& edit,
                                       EarlierNets& nets) {
  return std::visit(NetEditor(surface, scale, nets), edit);
}

}  // namespace foldwright
