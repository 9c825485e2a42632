// How close parts come to those that people drew: over a folder of off/ID.off and seg/ID/*.seg such
// as the Princeton Segmentation Benchmark, 1 - Rand Index and Cut Discrepancy by category, and what
// smoothing does to the borders. `bench_segmentation [FOLDER]`

#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <numbers>
#include <set>

#include "learned_model.h"
#include "segment/segment.h"
#include "segmentation_scores.h"

namespace {

using namespace foldwright;
namespace fs = std::filesystem;
using Segmentation = std::vector<int>;

constexpr int kIdsPerCategory = 20;
constexpr const char* kCategories[] = {"Human", "Cup",     "Glasses", "Airplane", "Ant",
                                       "Chair", "Octopus", "Table",   "Teddy",    "Hand",
                                       "Plier", "Fish",    "Bird",    "-",        "Armadillo",
                                       "Bust",  "Mech",    "Bearing", "Vase",     "FourLeg"};

// A border edge lies on a crease when its faces bend by more than this, in radians.
constexpr double kCrease = 20 * std::numbers::pi / 180;

struct Model {
  int id;
  fs::path file;
  std::vector<Segmentation> people;

  int category() const { return (id - 1) / kIdsPerCategory; }
};

std::vector<Model> models_in(const fs::path& folder) {
  std::map<int, Model> models;
  for (const auto& entry : fs::directory_iterator(folder / "off")) {
    const int id = std::stoi(entry.path().stem().string());
    Model model{id, entry.path(), {}};
    std::set<fs::path> files;
    for (const auto& seg : fs::directory_iterator(folder / "seg" / std::to_string(id))) {
      files.insert(seg.path());
    }
    for (const fs::path& file : files) {
      std::ifstream in(file);
      model.people.emplace_back(std::istream_iterator<int>(in), std::istream_iterator<int>());
    }
    models.emplace(id, std::move(model));
  }
  std::vector<Model> sorted;
  for (auto& [id, model] : models) sorted.push_back(std::move(model));
  return sorted;
}

/// The mean number of segments that people drew, by category.
std::map<int, int> parts_by_category(const std::vector<Model>& models) {
  std::map<int, std::pair<double, int>> sums;
  for (const Model& model : models) {
    for (const Segmentation& person : model.people) {
      auto& [sum, count] = sums[model.category()];
      sum += static_cast<double>(std::set<int>(person.begin(), person.end()).size());
      ++count;
    }
  }
  std::map<int, int> parts;
  for (const auto& [category, sum] : sums) {
    parts[category] = static_cast<int>(std::lround(sum.first / sum.second));
  }
  return parts;
}

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

/// Parts of a learned model, per face of its file, and their borders.
Segmentation segmentation(const JobState& state, Segmenter segmenter, bool smooth, int face_count,
                          Borders& borders) {
  const Mesh& mesh = state.surface->mesh;
  Segmentation labels(mesh.faces.size(), -1);
  double area = 0;
  for (int face = 0; face < mesh.face_count(); ++face) area += face_area(mesh, face);
  int parts = 0;
  for (const Component& component : state.components) {
    Labels own(component.graph.panel_count(), 0);
    if (component.learned) {
      const Learned& learned = *component.learned;
      const DualGraph graph = restrict_to(learned.surface->graph, learned.panels);
      own = carry_labels(mesh, component.graph, {learned.matrix, learned.rows},
                         segment(learned.surface->mesh, graph, learned.matrix,
                                 {segmenter, component.parts, state.options.seed}));
      if (smooth) own = smooth_labels(mesh, component.graph, learned.matrix.size, std::move(own));
      borders.add(component.graph, own, std::sqrt(area));
    }
    for (int panel = 0; panel < component.graph.panel_count(); ++panel) {
      for (const int face : component.graph.panel_faces(panel)) labels[face] = parts + own[panel];
    }
    parts += part_count(own);
  }
  Segmentation of_file(face_count, -1);
  for (int face = 0; face < mesh.face_count(); ++face) {
    of_file[mesh.source_faces[face]] = labels[face];
  }
  return of_file;
}

/// Means over people, then over the models of a category, then over categories.
class Means {
 public:
  void add(int category, double value) { values_[category].push_back(value); }
  double of(int category) const {
    double sum = 0;
    for (const double value : values_.at(category)) sum += value;
    return sum / static_cast<double>(values_.at(category).size());
  }
  double of_all() const {
    double sum = 0;
    for (const auto& [category, values] : values_) sum += of(category);
    return sum / static_cast<double>(values_.size());
  }
  bool has(int category) const { return values_.contains(category); }

 private:
  std::map<int, std::vector<double>> values_;
};

enum Column { kWithNumber, kAuto, kPaperOnly, kUnsmoothed, kOneSegment, kPeople, kColumnCount };
constexpr const char* kColumns[] = {"number", "auto", "paper", "unsmoothed", "one", "people"};

/// Labels of the file's faces on those of its mesh.
Segmentation on_mesh(const Mesh& mesh, const Segmentation& of_file) {
  Segmentation labels;
  for (const int face : mesh.source_faces) labels.push_back(of_file[face]);
  return labels;
}

struct Scores {
  Means rand_index, of_cuts, of_vertices;

  void add(const Model& model, const Mesh& mesh, const Segmentation& parts) {
    double error = 0, cuts = 0, vertices = 0;
    int cut = 0;
    for (const Segmentation& person : model.people) {
      error += testing::rand_index_error(parts, person);
      const testing::CutDiscrepancy discrepancy =
          testing::cut_discrepancy(mesh, on_mesh(mesh, parts), on_mesh(mesh, person));
      if (!discrepancy.exists) continue;
      cuts += discrepancy.of_cuts;
      vertices += discrepancy.of_vertices;
      ++cut;
    }
    rand_index.add(model.category(), error / static_cast<double>(model.people.size()));
    if (cut == 0) return;
    of_cuts.add(model.category(), cuts / cut);
    of_vertices.add(model.category(), vertices / cut);
  }
};

void add_people(const Model& model, Means& means) {
  double sum = 0;
  int pairs = 0;
  for (std::size_t a = 0; a < model.people.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      sum += testing::rand_index_error(model.people[a], model.people[b]);
      ++pairs;
    }
  }
  if (pairs > 0) means.add(model.category(), sum / pairs);
}

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
  const fs::path folder = argc > 1 ? fs::path(argv[1]) : testing::shared_folder() / "psb-subset";
  if (!fs::exists(folder / "off")) {
    std::printf("segmentation: no folder %s with off/ and seg/\n", folder.string().c_str());
    return 0;
  }
  const std::vector<Model> models = models_in(folder);
  const std::map<int, int> parts = parts_by_category(models);
  Scores scores[kColumnCount];
  Borders smooth, rough, ignored;
  for (const Model& model : models) {
    const int faces = static_cast<int>(model.people[0].size());
    const JobState with_number =
        testing::learn_model(model.file, {.parts = parts.at(model.category())});
    const Mesh& mesh = with_number.surface->mesh;
    const auto add = [&](Column column, const Segmentation& labels) {
      scores[column].add(model, mesh, labels);
    };
    add(kWithNumber, segmentation(with_number, Segmenter::kShape, true, faces, smooth));
    add(kUnsmoothed, segmentation(with_number, Segmenter::kShape, false, faces, rough));
    add(kPaperOnly, segmentation(with_number, Segmenter::kFoldability, false, faces, ignored));
    add(kAuto, segmentation(testing::learn_model(model.file, {}), Segmenter::kShape, true, faces,
                            ignored));
    add(kOneSegment, Segmentation(faces, 0));
    add_people(model, scores[kPeople].rand_index);
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
  std::printf("\nborders: length %.2f -> %.2f, on creases %.0f %% -> %.0f %% by smoothing\n",
              rough.length / static_cast<double>(models.size()),
              smooth.length / static_cast<double>(models.size()),
              100 * rough.creased / rough.length, 100 * smooth.creased / smooth.length);
  return 0;
}
