// How close parts come to those that people drew: over a folder of off/ID.off and seg/ID/*.seg such
// as the Princeton Segmentation Benchmark, 1 - Rand Index and Cut Discrepancy by category, how
// far parts of symmetric models mirror each other, and what smoothing does to the borders.
// `bench_segmentation [FOLDER [SEED]]`: means differ by half a percent between seeds.

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <numbers>

#include "learned_model.h"
#include "princeton.h"
#include "segment/mirrored_panels.h"
#include "segment/segment.h"

namespace {

using namespace foldwright;
using namespace foldwright::testing;

// A border edge lies on a crease when its faces bend by more than this, in radians.
constexpr double kCrease = 20 * std::numbers::pi / 180;

struct Borders {
  double length = 0;  ///< over the square root of the surface's area
  double creased = 0;

  void add(const DualGraph& graph, const Labels& labels, double unit) {
    for (const Hinge& hinge : graph.hinges) {
      if (labels[hinge.panels[0]] == labels[hinge.panels[1]]) continue;
      length += hinge.length / unit;
      if (std::abs(hinge.angle) > kCrease) creased += hinge.length / unit;
    }
  }
};

/// How far parts of models with a mirror plane mirror each other.
struct Symmetry {
  double sum = 0;
  int models = 0;

  void add(const Mesh& mesh, const Component& component, const Labels& labels) {
    const Learned& learned = *component.learned;
    const DualGraph graph = restrict_to(learned.surface->graph, learned.panels);
    const std::optional<Mirror> mirror = find_mirror(learned.surface->mesh, graph.faces);
    if (!mirror) return;
    const std::vector<int> images = mirrored_panels(mesh, component.graph, *mirror);
    sum += mirror_symmetry(labels, component.graph.areas, images);
    ++models;
  }
  double mean() const { return sum / models; }
};

/// Parts of a learned model, per face of its file, and their borders.
Segmentation segmentation(const JobState& state, Segmenter segmenter, bool smooth, int face_count,
                          Borders& borders, Symmetry& symmetry) {
  const Mesh& mesh = state.model.surface->mesh;
  Segmentation labels(mesh.faces.size(), -1);
  double area = 0;
  for (int face = 0; face < mesh.face_count(); ++face) area += face_area(mesh, face);
  int parts = 0;
  for (const Component& component : state.parts.components) {
    Labels own(component.graph.panel_count(), 0);
    if (component.learned) {
      const Learned& learned = *component.learned;
      const DualGraph graph = restrict_to(learned.surface->graph, learned.panels);
      own = carry_labels(mesh, component.graph, {learned.matrix, learned.rows},
                         segment(learned.surface->mesh, graph, learned.matrix,
                                 {.segmenter = segmenter,
                                  .parts = component.parts,
                                  .whole_first = component.whole_first,
                                  .seed = state.options.seed}));
      if (smooth) {
        own =
            smooth_labels(mesh, component.graph, std::move(own), {segmenter, learned.matrix.size});
      }
      borders.add(component.graph, own, std::sqrt(area));
      symmetry.add(mesh, component, own);
    }
    for (int panel = 0; panel < component.graph.panel_count(); ++panel) {
      for (const int face : component.graph.panel_faces(panel)) labels[face] = parts + own[panel];
    }
    parts += part_count(own);
  }
  return on_file(mesh, labels, face_count);
}

enum Column { kWithNumber, kAuto, kPaperOnly, kUnsmoothed, kOneSegment, kPeople, kColumnCount };
constexpr const char* kColumns[] = {"number", "auto", "paper", "unsmoothed", "one", "people"};

void print(const char* title, const Means* columns[], int count, double scale) {
  std::printf("\n%-12s", title);
  for (int c = 0; c < count; ++c) std::printf("%12s", kColumns[c]);
  std::puts("");
  for (int category = 0; category < static_cast<int>(std::size(kCategories)); ++category) {
    if (!columns[0]->has(category)) continue;
    std::printf("%-12s", kCategories[category]);
    for (int c = 0; c < count; ++c) {
      if (columns[c]->has(category)) {
        std::printf("%12.2f", scale * columns[c]->of(category));
      } else {
        std::printf("%12s", "-");
      }
    }
    std::puts("");
  }
  std::printf("%-12s", "all");
  for (int c = 0; c < count; ++c) std::printf("%12.2f", scale * columns[c]->of_all());
  std::puts("");
}

}  // namespace

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : shared_folder() / "psb-subset";
  const auto seed = static_cast<std::uint32_t>(argc > 2 ? std::atoi(argv[2]) : 1);
  const auto models = benchmark_models(folder);
  if (models.empty()) {
    std::printf("segmentation: no folder %s with off/ and seg/\n", folder.string().c_str());
    return 0;
  }
  const std::map<int, int> parts = parts_by_category(models);
  BenchmarkScores scores[kColumnCount];
  Borders smooth, rough, ignored;
  Symmetry symmetry[kOneSegment];
  for (const BenchmarkModel& model : models) {
    const int faces = model.face_count();
    const JobState with_number =
        learn_model(model.file, {.parts = {.count = parts.at(model.category())}, .seed = seed});
    const Mesh& mesh = with_number.model.surface->mesh;
    const auto add = [&](Column column, const Segmentation& labels) {
      scores[column].add(model, mesh, labels);
    };
    const auto segmented = [&](Column column, const JobState& state, Segmenter segmenter,
                               Borders& borders) {
      add(column,
          segmentation(state, segmenter, column != kUnsmoothed, faces, borders, symmetry[column]));
    };
    segmented(kWithNumber, with_number, Segmenter::kShape, smooth);
    segmented(kUnsmoothed, with_number, Segmenter::kShape, rough);
    segmented(kPaperOnly, with_number, Segmenter::kFoldability, ignored);
    segmented(kAuto, learn_model(model.file, {.seed = seed}), Segmenter::kShape, ignored);
    add(kOneSegment, Segmentation(faces, 0));
    scores[kPeople].add_people(model, mesh);
    std::fprintf(stderr, "%d ", model.id);
  }
  std::fputs("\n", stderr);
  const Means* columns[kColumnCount];
  for (int c = 0; c < kColumnCount; ++c) columns[c] = &scores[c].rand_index;
  print("1 - RI, %", columns, kColumnCount, 100);
  for (int c = 0; c < kOneSegment; ++c) columns[c] = &scores[c].of_cuts;
  print("CD, cuts", columns, kOneSegment, 1);
  for (int c = 0; c < kOneSegment; ++c) columns[c] = &scores[c].of_vertices;
  print("CD, vertices", columns, kOneSegment, 1);
  std::printf("\n%-12s", "mirrored, %");
  for (int c = 0; c < kOneSegment; ++c) std::printf("%12.2f", 100 * symmetry[c].mean());
  std::printf("  (%d models with a mirror plane)\n", symmetry[kWithNumber].models);
  std::printf("\nborders: length %.2f -> %.2f, on creases %.0f %% -> %.0f %% by smoothing\n",
              rough.length / static_cast<double>(models.size()),
              smooth.length / static_cast<double>(models.size()),
              100 * rough.creased / rough.length, 100 * smooth.creased / smooth.length);
  return 0;
}
