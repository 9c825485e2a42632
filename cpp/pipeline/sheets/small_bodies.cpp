#include "pipeline/sheets/small_bodies.h"

#include <algorithm>
#include <utility>

namespace foldwright {
namespace {

/// Per body its longest side along an axis, in model units.
std::vector<double> body_lengths(const Mesh& mesh) {
  std::vector<Eigen::AlignedBox3d> boxes(mesh.component_count);
  for (int f = 0; f < mesh.face_count(); ++f) {
    for (const int v : mesh.faces[f]) boxes[mesh.components[f]].extend(mesh.positions[v]);
  }
  std::vector<double> lengths;
  for (const Eigen::AlignedBox3d& box : boxes) lengths.push_back(box.sizes().maxCoeff());
  return lengths;
}

int body_of(const JobState& state, const FoundNet& net) {
  const DualGraph& graph = state.parts.components[net.region.component].graph;
  return state.model.surface->mesh.components[graph.panel_faces(net.region.panels[0])[0]];
}

}  // namespace

std::set<int> small_bodies(const JobState& state, double scale) {
  std::set<int> small;
  if (state.options.paper.min_piece == 0) return small;
  const std::vector<double> lengths = body_lengths(state.model.surface->mesh);
  const double longest = std::ranges::max(lengths);
  for (int body = 0; body < static_cast<int>(lengths.size()); ++body) {
    if (lengths[body] < longest && lengths[body] * scale < state.options.paper.min_piece) {
      small.insert(body);
    }
  }
  return small;
}

PrintedNets without_small_bodies(const JobState& state, double scale) {
  PrintedNets nets;
  const std::set<int> small = small_bodies(state, scale);
  for (const FoundNet& net : state.nets.found) {
    const bool is_small = !small.empty() && small.contains(body_of(state, net));
    (is_small ? nets.left_out : nets.printed).push_back(net);
  }
  // The longest body may have no net yet, where a job was cancelled.
  if (nets.printed.empty()) std::swap(nets.printed, nets.left_out);
  return nets;
}

void add_small_bodies_notice(JobState& state, double scale) {
  const std::set<int> small = small_bodies(state, scale);
  if (small.empty()) return;
  const Mesh& mesh = state.model.surface->mesh;
  const auto faces =
      std::ranges::count_if(mesh.components, [&](int body) { return small.contains(body); });
  state.notices.push_back({"small-bodies",
                           {{"count", small.size()},
                            {"faces", static_cast<int>(faces)},
                            {"limit_mm", state.options.paper.min_piece}}});
}

}  // namespace foldwright
