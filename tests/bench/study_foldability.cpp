// Fig. 7 of the paper: the foldability matrix sorted by part, and the parts before and after
// isolated panels were handed on. `bench_study_foldability [FOLDER]`

#include <algorithm>
#include <cstdio>
#include <numeric>

#include "learned_model.h"
#include "mesh_picture.h"
#include "pipeline/parts/matrix_picture.h"
#include "segment/connect_parts.h"
#include "segment/spectral.h"
#include "study.h"

namespace {

using namespace foldwright;
using namespace foldwright::testing;

constexpr int kParts = 10, kFaces = 1000;
constexpr double kSide = 512, kTop = 30;

/// Panels that are not in the largest piece of their part, by area in percent.
double isolated(const DualGraph& graph, const Labels& labels) {
  const std::vector<int> piece = part_pieces(graph, labels);
  std::vector<double> area(part_count(piece), 0), largest(part_count(labels), 0);
  double total = 0, main = 0;
  for (int panel = 0; panel < graph.panel_count(); ++panel) {
    area[piece[panel]] += graph.areas[panel];
    total += graph.areas[panel];
  }
  for (int panel = 0; panel < graph.panel_count(); ++panel) {
    largest[labels[panel]] = std::max(largest[labels[panel]], area[piece[panel]]);
  }
  for (const double share : largest) main += share;
  return std::max(0.0, 100 * (total - main) / total);
}

std::vector<int> on_faces(const Mesh& mesh, const DualGraph& graph, const Labels& labels) {
  std::vector<int> of_faces(mesh.faces.size());
  for (int panel = 0; panel < graph.panel_count(); ++panel) {
    for (const int face : graph.panel_faces(panel)) of_faces[face] = labels[panel];
  }
  return of_faces;
}

void draw_matrix(SvgCanvas& canvas, const Vec2& at, const MatrixPicture& picture) {
  const double cell = kSide / picture.size;
  for (int row = 0; row < picture.size; ++row) {
    for (int column = 0; column < picture.size; ++column) {
      const double value = picture.values[static_cast<std::size_t>(row) * picture.size + column];
      canvas.rectangle({at.x() + cell * column, at.y() + cell * row, cell, cell},
                       heat_colour(value / 255));
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (!has_study_models("study of foldability")) return 0;
  const StudyFolder folder(std::span(argv, static_cast<std::size_t>(argc)));
  Table table({"model", "panels", "isolated before, % of area", "after"});
  for (const char* model : kStudyModels) {
    const JobState state = learn_model(organic_model(model, kFaces), {.parts = {.count = kParts}});
    const Component& component = state.parts.components.front();
    const Mesh& mesh = component.learned->surface->mesh;
    const DualGraph graph =
        restrict_to(component.learned->surface->graph, component.learned->panels);
    const FoldabilityMatrix& matrix = component.learned->matrix;
    std::vector<int> rows(graph.panel_count());
    std::iota(rows.begin(), rows.end(), 0);
    const Labels before = spectral_clusters(foldability_affinity(matrix), {.parts = kParts});
    const Labels after = connect_parts(graph, {matrix, rows}, before);
    table.add({model, std::to_string(graph.panel_count()), decimal(isolated(graph, before), 2),
               decimal(isolated(graph, after), 2)});
    SvgCanvas canvas(kSide + 2 * kSide, kSide + kTop);
    draw_matrix(canvas, {0, kTop}, make_matrix_picture(matrix, after));
    draw_mesh(canvas, {kSide + 16, kTop, kSide - 32, kSide}, mesh, on_faces(mesh, graph, before),
              widest_eye(mesh));
    draw_mesh(canvas, {2 * kSide + 16, kTop, kSide - 32, kSide}, mesh, on_faces(mesh, graph, after),
              widest_eye(mesh));
    const char* const titles[] = {"foldability, sorted by part", "before", "after"};
    for (int i = 0; i < 3; ++i) {
      canvas.text({kSide * (i + 0.5), 20}, 14, Anchor::kMiddle, titles[i]);
    }
    folder.save("figure-7-" + std::string(model) + ".svg", canvas.svg());
  }
  folder.save(
      "figure-7.md",
      "Fig. 7: panels apart from their part, before and after they are handed on by Eq. (1)",
      table);
  return 0;
}
