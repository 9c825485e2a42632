// Fig. 12 of the paper: models of the Princeton Segmentation Benchmark in their parts, one of each
// category. `bench_study_gallery [FOLDER]`

#include <cstdio>

#include "learned_model.h"
#include "mesh_picture.h"
#include "princeton.h"
#include "study.h"

namespace {

using namespace foldwright;
using namespace foldwright::testing;

constexpr int kFaces = 3000;  // as many as show the shape
constexpr int kColumns = 5;
constexpr double kTile = 220, kCaption = 24;

}  // namespace

int main(int argc, char** argv) {
  const auto models = benchmark_models(shared_folder() / "psb-subset");
  if (models.empty()) {
    std::printf("study of the gallery: %s\n", kNoSharedModels);
    return 0;
  }
  const StudyFolder folder(std::span(argv, static_cast<std::size_t>(argc)));
  const std::map<int, int> parts = parts_by_category(models);
  const int rows = (static_cast<int>(parts.size()) + kColumns - 1) / kColumns;
  SvgCanvas canvas(kColumns * kTile, rows * (kTile + kCaption));
  int tile = 0, last_category = -1;
  for (const BenchmarkModel& model : models) {
    if (model.category() == last_category) continue;
    last_category = model.category();
    const int wanted = parts.at(model.category());
    const JobState state =
        learn_model(model.file, {.model = {.faces = kFaces}, .parts = {.count = wanted}});
    const Mesh& mesh = state.model.surface->mesh;
    const double x = kTile * (tile % kColumns);
    const double y = (kTile + kCaption) * (tile / kColumns);
    draw_mesh(canvas, {x + 8, y + 8, kTile - 16, kTile - 16}, mesh, parts_of(state, wanted),
              widest_eye(mesh));
    canvas.text({x + kTile / 2, y + kTile + 14}, 14, Anchor::kMiddle,
                std::string(kCategories[model.category()]) + ", " + std::to_string(wanted));
    ++tile;
  }
  folder.save("figure-12.svg", canvas.svg());
  std::printf("Fig. 12: %d models in figure-12.svg\n", tile);
  return 0;
}
