// Fig. 11 of the paper: Rand Index and Cut Discrepancy on the Princeton Segmentation Benchmark, by
// category. `bench_study_benchmark [FOLDER]`

#include <cstdio>

#include "learned_model.h"
#include "princeton.h"
#include "study.h"
#include "svg_canvas.h"

namespace {

using namespace foldwright;
using namespace foldwright::testing;

enum Series { kShapeToo, kPaperOnly, kPeople, kSeriesCount };
constexpr const char* kSeries[] = {"foldability and shape", "foldability alone [paper]", "people"};

constexpr double kBar = 12, kGroup = 3 * kBar + 14, kChart = 200, kTop = 56, kBottom = 70;
constexpr double kLeft = 50;

/// One measure of all series.
struct Measure {
  const char* title;
  const Means* series[kSeriesCount];
  double scale;  ///< of the values
  double top;    ///< value of a full bar
  double step;   ///< between grid lines
};

std::vector<int> categories_of(const Means& means) {
  std::vector<int> categories;
  for (int category = 0; category < static_cast<int>(std::size(kCategories)); ++category) {
    if (means.has(category)) categories.push_back(category);
  }
  return categories;
}

void draw_grid(SvgCanvas& canvas, const Measure& measure, double y, double width) {
  for (double value = 0; value <= measure.top; value += measure.step) {
    const double at = y + kTop + kChart * (1 - value / measure.top);
    canvas.line({kLeft, at}, {width, at}, 0.5, {0.8, 0.8, 0.8});
    canvas.text({kLeft - 6, at + 4}, 11, Anchor::kEnd, decimal(value, measure.step < 1 ? 1 : 0));
  }
}

/// Bars of all series by category, and at the right their means.
void draw_bars(SvgCanvas& canvas, const Measure& measure, double y, double width) {
  canvas.text({kLeft, y + 18}, 15, Anchor::kStart, measure.title);
  for (int s = 0; s < kSeriesCount; ++s) {
    canvas.rectangle({kLeft + 190.0 * s, y + 28, 12, 12}, part_colour(s));
    canvas.text({kLeft + 190.0 * s + 18, y + 39}, 12, Anchor::kStart, kSeries[s]);
  }
  draw_grid(canvas, measure, y, width);
  double x = kLeft + 8;
  const auto group = [&](const char* name, const auto& value_of) {
    for (int s = 0; s < kSeriesCount; ++s) {
      const double share =
          std::min(1.0, measure.scale * value_of(*measure.series[s]) / measure.top);
      canvas.rectangle({x + kBar * s, y + kTop + kChart * (1 - share), kBar - 2, kChart * share},
                       part_colour(s));
    }
    canvas.text({x + 1.5 * kBar, y + kTop + kChart + 16}, 10, Anchor::kMiddle, name);
    x += kGroup;
  };
  for (const int category : categories_of(*measure.series[0])) {
    group(kCategories[category],
          [&](const Means& means) { return means.has(category) ? means.of(category) : 0.0; });
  }
  group("all", [](const Means& means) { return means.of_all(); });
}

Table table_of(const BenchmarkScores (&scores)[kSeriesCount]) {
  Table table({"category", "1 - RI, %", "paper", "people", "CD", "paper", "people"});
  const auto row = [&](const char* name, const auto& value_of) {
    std::vector<std::string> cells = {name};
    for (const BenchmarkScores& s : scores)
      cells.push_back(decimal(100 * value_of(s.rand_index), 1));
    for (const BenchmarkScores& s : scores) cells.push_back(decimal(value_of(s.of_cuts), 2));
    table.add(cells);
  };
  for (const int category : categories_of(scores[0].rand_index)) {
    row(kCategories[category], [&](const Means& means) {
      return means.has(category) ? means.of(category) : std::nan("");
    });
  }
  row("all", [](const Means& means) { return means.of_all(); });
  return table;
}

}  // namespace

int main(int argc, char** argv) {
  const auto models = benchmark_models(shared_folder() / "psb-subset");
  if (models.empty()) {
    std::printf("study of the benchmark: %s\n", kNoSharedModels);
    return 0;
  }
  const StudyFolder folder(std::span(argv, static_cast<std::size_t>(argc)));
  const std::map<int, int> parts = parts_by_category(models);
  BenchmarkScores scores[kSeriesCount];
  for (const BenchmarkModel& model : models) {
    const int wanted = parts.at(model.category());
    JobState state = learn_model(model.file, {.parts = {.count = wanted}});
    const Mesh& mesh = state.model.surface->mesh;
    for (const Segmenter segmenter : {Segmenter::kShape, Segmenter::kFoldability}) {
      state.options.parts.segmenter = segmenter;
      scores[segmenter == Segmenter::kShape ? kShapeToo : kPaperOnly].add(
          model, mesh, on_file(mesh, parts_of(state, wanted), model.face_count()));
    }
    scores[kPeople].add_people(model, mesh);
  }
  Measure rand_index{"1 - Rand Index, %", {}, 100, 50, 10};
  Measure discrepancy{"Cut Discrepancy", {}, 1, 2.5, 0.5};
  for (int s = 0; s < kSeriesCount; ++s) {
    rand_index.series[s] = &scores[s].rand_index;
    discrepancy.series[s] = &scores[s].of_cuts;
  }
  const auto groups = static_cast<double>(1 + categories_of(scores[0].rand_index).size());
  const double width = kLeft + 8 + kGroup * groups;
  const double height = kTop + kChart + kBottom;
  SvgCanvas canvas(width, 2 * height);
  draw_bars(canvas, rand_index, 0, width);
  draw_bars(canvas, discrepancy, height, width);
  folder.save("figure-11.svg", canvas.svg());
  folder.save("figure-11.md",
              "Fig. 11: differences from what people drew, " + std::to_string(models.size()) +
                  " models of the benchmark, as many parts as people drew in the category",
              table_of(scores));
  return 0;
}
