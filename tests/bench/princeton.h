#pragma once

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "segmentation_scores.h"
#include "shared_models.h"

/// The Princeton Segmentation Benchmark (Chen, Golovinskiy and Funkhouser 2009), or some of it: a
/// folder of off/ID.off and seg/ID/*.seg.
namespace foldwright::testing {

/// A part per face of a file.
using Segmentation = std::vector<int>;

inline constexpr int kIdsPerCategory = 20;
inline constexpr const char* kCategories[] = {
    "Human",     "Cup",   "Glasses", "Airplane", "Ant",  "Chair",  "Octopus",
    "Table",     "Teddy", "Hand",    "Plier",    "Fish", "Bird",   "-",
    "Armadillo", "Bust",  "Mech",    "Bearing",  "Vase", "FourLeg"};

/// A model with what people made of it.
struct BenchmarkModel {
  int id;
  std::filesystem::path file;
  std::vector<Segmentation> people;

  int category() const { return (id - 1) / kIdsPerCategory; }
  int face_count() const { return static_cast<int>(people[0].size()); }
};

/// The models of a benchmark's folder by their ids; none when it is missing.
inline std::vector<BenchmarkModel> benchmark_models(const std::filesystem::path& folder) {
  namespace fs = std::filesystem;
  std::map<int, BenchmarkModel> models;
  if (!fs::exists(folder / "off")) return {};
  for (const auto& entry : fs::directory_iterator(folder / "off")) {
    const int id = std::stoi(entry.path().stem().string());
    BenchmarkModel model{id, entry.path(), {}};
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
  std::vector<BenchmarkModel> sorted;
  for (auto& [id, model] : models) sorted.push_back(std::move(model));
  return sorted;
}

/// The mean number of segments that people drew, by category.
inline std::map<int, int> parts_by_category(const std::vector<BenchmarkModel>& models) {
  std::map<int, std::pair<double, int>> sums;
  for (const BenchmarkModel& model : models) {
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

/// Labels of the faces of a mesh on those of its file; -1 where the mesh has none.
inline Segmentation on_file(const Mesh& mesh, const std::vector<int>& labels, int face_count) {
  Segmentation of_file(face_count, -1);
  for (int face = 0; face < mesh.face_count(); ++face) {
    of_file[mesh.source_faces[face]] = labels[face];
  }
  return of_file;
}

/// Labels of the file's faces on those of its mesh.
inline Segmentation on_mesh(const Mesh& mesh, const Segmentation& of_file) {
  Segmentation labels;
  for (const int face : mesh.source_faces) labels.push_back(of_file[face]);
  return labels;
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

/// Scores of segmentations against those of people.
struct BenchmarkScores {
  Means rand_index;            ///< 1 - Rand Index
  Means of_cuts, of_vertices;  ///< Cut Discrepancy

  /// `parts`: of the faces of the model's file. `mesh`: that file's.
  void add(const BenchmarkModel& model, const Mesh& mesh, const Segmentation& parts) {
    double error = 0, cuts = 0, vertices = 0;
    int cut = 0;
    for (const Segmentation& person : model.people) {
      error += rand_index_error(parts, person);
      const CutDiscrepancy discrepancy =
          cut_discrepancy(mesh, on_mesh(mesh, parts), on_mesh(mesh, person));
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

  /// Scores people against each other: every pair by Rand Index, and each with the next by Cut
  /// Discrepancy, which takes far longer.
  void add_people(const BenchmarkModel& model, const Mesh& mesh) {
    double error = 0, cuts = 0;
    int pairs = 0, cut = 0;
    for (std::size_t a = 0; a < model.people.size(); ++a) {
      for (std::size_t b = 0; b < a; ++b) {
        error += rand_index_error(model.people[a], model.people[b]);
        ++pairs;
      }
      if (a == 0) continue;
      const CutDiscrepancy discrepancy =
          cut_discrepancy(mesh, on_mesh(mesh, model.people[a - 1]), on_mesh(mesh, model.people[a]));
      if (!discrepancy.exists) continue;
      cuts += discrepancy.of_cuts;
      ++cut;
    }
    if (pairs > 0) rand_index.add(model.category(), error / pairs);
    if (cut > 0) of_cuts.add(model.category(), cuts / cut);
  }
};

}  // namespace foldwright::testing
