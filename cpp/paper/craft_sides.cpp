#include "paper/craft_sides.h"

#include <algorithm>
#include <map>
#include <utility>

#include "paper/flaps.h"

namespace foldwright {
namespace {

/// Edges of a panel one after the other, from a corner of the face in a slot.
struct EdgeRun {
  int slot, corner;
  int hinge;     ///< -1 at the border of the piece
  int from, to;  ///< vertices of the mesh
  int lowest;    ///< mesh edge
};

class Builder {
 public:
  Builder(const Mesh& mesh, const DualGraph& graph, const CraftMeasure& measure)
      : mesh_(mesh), graph_(graph), scale_(measure.scale), probe_(measure.probe), panels_(mesh) {
    for (int h = 0; h < graph.hinge_count(); ++h) {
      for (const int e : graph.hinges[h].edges) hinge_of_[e] = h;
    }
    for (const BorderRoom& border : measure.borders) elsewhere_[border.mesh_edge] = border.height;
  }

  CraftSides build() {
    for (int panel = 0; panel < graph_.panel_count(); ++panel) {
      for (const EdgeRun& run : runs_of_panel(panel)) add(run);
    }
    const auto side_count = static_cast<int>(found_.sides.size());
    found_.first_side.resize(graph_.triangles.size() + 1, side_count);
    found_.seams_of_hinge.resize(graph_.hinge_count());
    for (std::size_t s = 0; s < found_.seams.size(); ++s) {
      const int hinge = found_.seams[s].hinge;
      if (hinge != -1) found_.seams_of_hinge[hinge].push_back(static_cast<int>(s));
    }
    return std::move(found_);
  }

 private:
  /// The edges of a panel that may be cut, by slot, then corner.
  std::vector<EdgeRun> edges_of_panel(int panel) const {
    std::vector<EdgeRun> edges;
    for (int slot = graph_.first_face[panel]; slot < graph_.first_face[panel + 1]; ++slot) {
      const int face = graph_.faces[slot];
      for (int i = 0; i < 3; ++i) {
        const int e = mesh_.face_edges[face][i];
        const auto hinge = hinge_of_.find(e);
        if (hinge == hinge_of_.end() && !elsewhere_.contains(e)) continue;
        const int h = hinge == hinge_of_.end() ? -1 : hinge->second;
        edges.push_back({slot, i, h, mesh_.faces[face][i], mesh_.faces[face][(i + 1) % 3], e});
      }
    }
    return edges;
  }

  /// The same with straight runs along a hinge as one; by where they start.
  std::vector<EdgeRun> runs_of_panel(int panel) const {
    const std::vector<EdgeRun> edges = edges_of_panel(panel);
    std::map<std::pair<int, int>, int> starts, ends;  // by hinge and vertex: which of them
    for (int i = 0; i < static_cast<int>(edges.size()); ++i) {
      if (edges[i].hinge == -1) continue;
      starts[{edges[i].hinge, edges[i].from}] = i;
      ends[{edges[i].hinge, edges[i].to}] = i;
    }
    std::vector<EdgeRun> runs;
    for (const EdgeRun& edge : edges) {
      if (ends.contains({edge.hinge, edge.from})) continue;
      EdgeRun& run = runs.emplace_back(edge);
      for (auto next = starts.find({run.hinge, run.to}); next != starts.end();
           next = starts.find({run.hinge, run.to})) {
        run.to = edges[next->second].to;
        run.lowest = std::min(run.lowest, edges[next->second].lowest);
      }
    }
    return runs;
  }

  void add(const EdgeRun& run) {
    CraftSide side = side_of(run);
    if (side.length <= kWantedLength) return;
    const auto index = static_cast<int>(found_.sides.size());
    while (static_cast<int>(found_.first_side.size()) <= run.slot) {
      found_.first_side.push_back(index);
    }
    const auto seam_count = static_cast<int>(found_.seams.size());
    const auto [seam, is_new] = seam_of_.emplace(run.lowest, seam_count);
    if (is_new) {
      const double height = run.hinge == -1 ? elsewhere_.at(run.lowest) : 0;
      found_.seams.push_back({run.lowest, run.hinge, {index, -1}, height});
    } else {
      found_.seams[seam->second].sides[1] = index;
    }
    found_.seam_of_side.push_back(seam->second);
    found_.sides.push_back(std::move(side));
  }

  CraftSide side_of(const EdgeRun& run) const {
    const int face = graph_.faces[run.slot];
    const Mesh::Edge& edge = mesh_.edges[mesh_.face_edges[face][run.corner]];
    const int across = edge.faces[0] == face ? edge.faces[1] : edge.faces[0];
    const Vec3& from = mesh_.positions[run.from];
    const Vec3& next = mesh_.positions[mesh_.faces[face][(run.corner + 1) % 3]];
    CraftSide side{run.slot,
                   run.corner,
                   (next - from).norm() * scale_,
                   (mesh_.positions[run.to] - from).norm() * scale_,
                   panels_.beyond(across, {run.from, run.to}, scale_),
                   0};
    RoomProfile room = open_room(side.length, probe_.height);
    lower_below(room, side.cover);
    const auto open = best_flap(room, side.cover.lean, probe_);
    side.open = open ? open->height : 0;
    return side;
  }

  const Mesh& mesh_;
  const DualGraph& graph_;
  double scale_;
  const FlapShape& probe_;
  MeshPanels panels_;
  std::map<int, int> hinge_of_;      ///< by mesh edge
  std::map<int, double> elsewhere_;  ///< by mesh edge
  std::map<int, int> seam_of_;       ///< by the lowest mesh edge
  CraftSides found_;
};

}  // namespace

CraftSides craft_sides(const Mesh& mesh, const DualGraph& graph, const CraftMeasure& measure) {
  return Builder(mesh, graph, measure).build();
}

}  // namespace foldwright
