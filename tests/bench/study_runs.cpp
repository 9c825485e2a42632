// Table 1 of the paper: how parts change with the number of learning runs. `bench_study_runs
// [FOLDER]`

#include <cstdio>
#include <iterator>

#include "learned_model.h"
#include "mesh_picture.h"
#include "segmentation_scores.h"
#include "study.h"

namespace {

using namespace foldwright;
using namespace foldwright::testing;

constexpr int kParts[] = {5, 7, 9, 11};
constexpr int kRuns[] = {25, 50, 100, 200, 400};
constexpr int kManyRuns = 1600;  // learned from so many, parts hardly change any more
constexpr int kFaces = 1000;
constexpr double kTile = 220, kMargin = 60;

/// Segmentations of one model by number of parts.
std::vector<std::vector<int>> segmentations(const char* model, int runs) {
  const JobState learned =
      learn_model(organic_model(model, kFaces), {.parts = {.count = 2, .runs = runs}});
  std::vector<std::vector<int>> all;
  for (const int parts : kParts) all.push_back(parts_of(learned, parts));
  return all;
}

/// The parts of one model: a row per number of runs, a column per number of parts.
SvgCanvas picture(const char* model, const std::vector<std::vector<std::vector<int>>>& by_runs) {
  const Mesh mesh = load(organic_model(model, kFaces)).mesh;
  SvgCanvas canvas(kMargin + kTile * std::size(kParts), kMargin / 2 + kTile * std::size(kRuns));
  for (std::size_t column = 0; column < std::size(kParts); ++column) {
    canvas.text({kMargin + kTile * (static_cast<double>(column) + 0.5), 20}, 14, Anchor::kMiddle,
                std::to_string(kParts[column]) + " parts");
  }
  for (std::size_t row = 0; row < std::size(kRuns); ++row) {
    const double y = kMargin / 2 + kTile * static_cast<double>(row);
    canvas.text({kMargin - 8, y + kTile / 2}, 14, Anchor::kEnd, std::to_string(kRuns[row]));
    for (std::size_t column = 0; column < std::size(kParts); ++column) {
      const PictureBox box = {kMargin + kTile * static_cast<double>(column) + 8, y + 8, kTile - 16,
                              kTile - 16};
      draw_mesh(canvas, box, mesh, by_runs[row][column], widest_eye(mesh));
    }
  }
  return canvas;
}

}  // namespace

int main(int argc, char** argv) {
  if (!has_study_models("study of runs")) return 0;
  const StudyFolder folder(std::span(argv, static_cast<std::size_t>(argc)));
  std::vector<std::vector<double>> differences(std::size(kRuns),
                                               std::vector<double>(std::size(kParts), 0));
  for (const char* model : kStudyModels) {
    const auto settled = segmentations(model, kManyRuns);
    std::vector<std::vector<std::vector<int>>> by_runs;
    for (std::size_t row = 0; row < std::size(kRuns); ++row) {
      by_runs.push_back(segmentations(model, kRuns[row]));
      for (std::size_t column = 0; column < std::size(kParts); ++column) {
        differences[row][column] +=
            100 * rand_index_error(by_runs[row][column], settled[column]) / std::size(kStudyModels);
      }
    }
    folder.save("table-1-" + std::string(model) + ".svg", picture(model, by_runs).svg());
  }
  Table table({"runs", "5 parts", "7", "9", "11"});
  for (std::size_t row = 0; row < std::size(kRuns); ++row) {
    std::vector<std::string> cells = {std::to_string(kRuns[row])};
    for (const double difference : differences[row]) cells.push_back(decimal(difference, 1));
    table.add(cells);
  }
  folder.save(
      "table-1.md",
      "Table 1: 1 - RI, %, to the parts after 1600 runs; mean of three models of 1000 faces",
      table);
  return 0;
}
