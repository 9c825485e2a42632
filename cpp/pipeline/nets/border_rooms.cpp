#include "pipeline/nets/border_rooms.h"

namespace foldwright {

BorderRooms::BorderRooms(const JobState& state) : edges_of_(state.nets.found.size()) {
  const Mesh& mesh = state.model.surface->mesh;
  std::vector<int> net_of(mesh.faces.size(), -1);
  for (std::size_t n = 0; n < state.nets.found.size(); ++n) {
    const Region& region = state.nets.found[n].region;
    const DualGraph& graph = state.parts.components[region.component].graph;
    for (const int panel : region.panels) {
      for (const int face : graph.panel_faces(panel)) net_of[face] = static_cast<int>(n);
    }
  }
  for (int e = 0; e < mesh.edge_count(); ++e) {
    const auto& faces = mesh.edges[e].faces;
    if (faces[1] == -1) continue;
    const std::array<int, 2> nets = {net_of[faces[0]], net_of[faces[1]]};
    if (nets[0] == nets[1] || nets[0] == -1 || nets[1] == -1) continue;
    borders_[e] = {{std::min(nets[0], nets[1]), std::max(nets[0], nets[1])}};
    for (const int net : nets) edges_of_[net].push_back(e);
  }
}

std::vector<BorderRoom> BorderRooms::seen_by(int net) const {
  std::vector<BorderRoom> rooms;
  for (const int e : edges_of_[net]) {
    const Border& border = borders_.at(e);
    const int own = border.nets[0] == net ? 0 : 1;
    const int answers = border.heights[1] > border.heights[0] ? 1 : 0;
    rooms.push_back({e, own == answers ? 0 : border.heights[answers]});
  }
  return rooms;
}

void BorderRooms::note(int net, const std::vector<BorderRoom>& rooms) {
  for (const BorderRoom& room : rooms) {
    Border& border = borders_.at(room.mesh_edge);
    border.heights[border.nets[0] == net ? 0 : 1] = room.height;
  }
}

}  // namespace foldwright
