#include "pipeline/parts/learning.h"

#include <algorithm>
#include <numeric>

#include "mesh/connectivity.h"
#include "mesh/decimate.h"
#include "mesh/nearest_face.h"

namespace foldwright {
namespace {

// Runs of a task: enough tasks to share among workers, few enough that adding their matrices up
// costs little.
constexpr int kRunsPerTask = 50;

int face_count(const DualGraph& graph) { return static_cast<int>(graph.faces.size()); }

std::vector<int> all_panels(const DualGraph& graph) {
  std::vector<int> panels(graph.panel_count());
  std::iota(panels.begin(), panels.end(), 0);
  return panels;
}

/// Per panel of the component the panel of the proxy nearest to its largest face.
std::vector<int> rows_on_proxy(const Mesh& mesh, const DualGraph& graph, const Mesh& own,
                               const Surface& proxy) {
  // `own` has the component's faces in the order of `graph.faces`.
  const std::vector<int> nearest = nearest_faces(own, proxy.mesh);
  std::vector<int> panel_of(proxy.mesh.faces.size());
  for (int panel = 0; panel < proxy.graph.panel_count(); ++panel) {
    for (const int face : proxy.graph.panel_faces(panel)) panel_of[face] = panel;
  }
  std::vector<int> rows;
  for (int panel = 0; panel < graph.panel_count(); ++panel) {
    int largest = graph.first_face[panel];
    for (int i = largest + 1; i < graph.first_face[panel + 1]; ++i) {
      if (face_area(mesh, graph.faces[i]) > face_area(mesh, graph.faces[largest])) largest = i;
    }
    rows.push_back(panel_of[nearest[largest]]);
  }
  return rows;
}

/// The surface to learn on, its panels, and the row of each panel of the component.
Learned choose_surface(const JobState& state, int index) {
  const Component& component = state.parts.components[index];
  const int limit = state.options.parts.proxy;
  if (limit > 0 && face_count(component.graph) > limit) {
    const Mesh& mesh = state.model.surface->mesh;
    const Mesh own = submesh(mesh, component.graph.faces);
    auto proxy = make_surface(kFirstProxySurface + index, decimate(own, limit));
    // A proxy that fell apart, or cannot tell the wanted parts apart, would mislead.
    if (is_connected(proxy->graph) && 4 * component.parts <= proxy->graph.panel_count()) {
      std::vector<int> rows = rows_on_proxy(mesh, component.graph, own, *proxy);
      std::vector<int> panels = all_panels(proxy->graph);
      return {std::move(proxy), std::move(panels), {}, std::move(rows)};
    }
  }
  return {state.model.surface, component.panels, {}, all_panels(component.graph)};
}

}  // namespace

Learning::Learning(const JobState& state, int component, TaskQueue& queue)
    : component_(component), learned_(choose_surface(state, component)) {
  LearnOptions options;
  options.heuristic = state.options.parts.heuristic;
  options.runs = state.options.parts.runs;
  options.seed =
      task_seed(state.options.seed, SeedTag::kComponent, static_cast<std::uint64_t>(component), 0);
  for (int run = 0; run < options.runs; run += kRunsPerTask) {
    const int last = std::min(run + kRunsPerTask, options.runs);
    last_task_ = queue.add(learned_.surface, learned_.panels, LearnTask{options, run, last});
    if (open_tasks_++ == 0) first_task_ = last_task_;
  }
}

bool Learning::complete(const FoldabilityCounts& counts) {
  counts_.add(counts);
  return --open_tasks_ == 0;
}

Learned Learning::finish() {
  learned_.matrix = to_matrix(counts_);
  return std::move(learned_);
}

}  // namespace foldwright
