#include "pipeline/sheets/flat_net.h"

#include "paper/grain.h"

namespace foldwright {

DualGraph graph_of(const JobState& state, const FoundNet& found) {
  return restrict_to(state.parts.components[found.region.component].graph, found.region.panels);
}

Net flatten(const JobState& state, const FoundNet& found, double scale) {
  Net net = make_net(state.model.surface->mesh, graph_of(state, found), found.folds);
  for (Vec2& p : net.vertices) p *= scale;
  return net;
}

Footprint footprint_of(const Net& net, std::span<const Flap> flaps) {
  Footprint print;
  for (const auto& [a, b, c] : net.corners) {
    const std::array<Vec2, 3> face = {net.vertices[a], net.vertices[b], net.vertices[c]};
    print.polygons.push_back({face.begin(), face.end()});
    print.face_area += 0.5 * cross(face[1] - face[0], face[2] - face[0]);
  }
  for (const Flap& flap : flaps)
    print.polygons.push_back({flap.corners.begin(), flap.corners.end()});
  print.grain = grain_of(net);
  return print;
}

}  // namespace foldwright
