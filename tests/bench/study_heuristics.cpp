// Table 2 of the paper: how alike parts are that were learned by different heuristics.
// `bench_study_heuristics [FOLDER]`

#include <cstdio>
#include <iterator>

#include "learned_model.h"
#include "mesh_picture.h"
#include "segmentation_scores.h"
#include "study.h"

namespace {

using namespace foldwright;
using namespace foldwright::testing;

constexpr int kParts = 9, kFaces = 1000;  // as in the paper; 400 runs are the default
constexpr double kTile = 240, kTop = 30;

struct Column {
  const char* name;
  Heuristic heuristic;
  std::uint32_t seed;
};
// The first is what the others are compared with; the second says how much is chance.
constexpr Column kColumns[] = {{"steepest edge", Heuristic::kSteepestEdge, 1},
                               {"steepest edge, other seed", Heuristic::kSteepestEdge, 2},
                               {"flat tree", Heuristic::kFlatTree, 1},
                               {"both in turn", Heuristic::kHybrid, 1},
                               {"random", Heuristic::kRandom, 1}};

std::vector<int> parts_by(const char* model, const Column& column) {
  const JobOptions options = {.parts = {.count = kParts, .heuristic = column.heuristic},
                              .seed = column.seed};
  return parts_of(learn_model(organic_model(model, kFaces), options), kParts);
}

}  // namespace

int main(int argc, char** argv) {
  if (!has_study_models("study of heuristics")) return 0;
  const StudyFolder folder(std::span(argv, static_cast<std::size_t>(argc)));
  std::vector<std::string> head = {"model"};
  for (const Column& column : kColumns) head.emplace_back(column.name);
  Table table(head);
  SvgCanvas canvas(kTile * std::size(kColumns), kTop + kTile * std::size(kStudyModels));
  double y = kTop;
  for (const char* model : kStudyModels) {
    const Mesh mesh = load(organic_model(model, kFaces)).mesh;
    std::vector<std::string> cells = {model};
    std::vector<int> first;
    double x = 0;
    for (const Column& column : kColumns) {
      const std::vector<int> parts = parts_by(model, column);
      if (first.empty()) first = parts;
      cells.push_back(decimal(100 * (1 - rand_index_error(parts, first)), 1));
      draw_mesh(canvas, {x + 8, y + 8, kTile - 16, kTile - 16}, mesh, parts, widest_eye(mesh));
      canvas.text({x + kTile / 2, 20}, 14, Anchor::kMiddle, column.name);
      x += kTile;
    }
    table.add(cells);
    y += kTile;
  }
  folder.save(
      "table-2.md",
      "Table 2: Rand Index, %, to the parts by steepest edge; 400 runs, 9 parts, 1000 faces",
      table);
  folder.save("table-2.svg", canvas.svg());
  return 0;
}
