// The studies of the paper's section 5, on the shared models: what runs, parts and heuristics
// change, pieces against other ways to make them, how even the pieces are, and how many folds are
// mountains.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "segmentation_scores.h"
#include "timed_job.h"
#include "unfold/directions.h"
#include "unfold/heuristics.h"
#include "unfold/layout.h"

namespace {

using namespace foldwright;

constexpr const char* kModels[] = {"spot", "koala", "cat"};

std::filesystem::path model_file(const std::string& name, int faces) {
  return testing::shared_folder() / "models/organic" /
         (name + "_" + std::to_string(faces) + ".obj");
}

std::shared_ptr<const JobResult> result_of(const std::filesystem::path& path,
                                           const JobOptions& options) {
  return testing::run_timed(path, options).result;
}

/// Segmentations differ by 1 - Rand Index, in percent, on average over the models.
double difference(const std::vector<std::shared_ptr<const JobResult>>& some,
                  const std::vector<std::shared_ptr<const JobResult>>& others) {
  double sum = 0;
  for (std::size_t i = 0; i < some.size(); ++i) {
    sum += testing::rand_index_error(some[i]->labels, others[i]->labels);
  }
  return 100 * sum / static_cast<double>(some.size());
}

std::vector<std::shared_ptr<const JobResult>> results(const JobOptions& options) {
  std::vector<std::shared_ptr<const JobResult>> all;
  for (const char* name : kModels) all.push_back(result_of(model_file(name, 1000), options));
  return all;
}

void study_runs() {
  std::puts("Table 1: runs x parts. 1 - RI, %, to the parts from 1600 runs; 3 models, 1000 faces");
  std::printf("%8s", "runs");
  for (const int parts : {5, 7, 9, 11}) std::printf("%8d", parts);
  std::puts("");
  std::map<int, std::vector<std::shared_ptr<const JobResult>>> reference;
  for (const int parts : {5, 7, 9, 11}) {
    reference[parts] = results({.parts = parts, .folding = FoldingMode::kOff, .runs = 1600});
  }
  for (const int runs : {25, 50, 100, 200, 400}) {
    std::printf("%8d", runs);
    for (const int parts : {5, 7, 9, 11}) {
      const JobOptions options = {.parts = parts, .folding = FoldingMode::kOff, .runs = runs};
      std::printf("%8.1f", difference(results(options), reference[parts]));
    }
    std::puts("");
    std::fflush(stdout);
  }
}

void study_heuristics() {
  std::puts(
      "\nTable 2: heuristics. 1 - RI, %, to steepest edge; 400 runs, 9 parts, 3 models, 1000 "
      "faces");
  const auto with = [](Heuristic heuristic, std::uint32_t seed) {
    return results(
        {.parts = 9, .heuristic = heuristic, .folding = FoldingMode::kOff, .seed = seed});
  };
  const auto steepest = with(Heuristic::kSteepestEdge, 1);
  const std::pair<const char*, Heuristic> rows[] = {
      {"steepest, other seed", Heuristic::kSteepestEdge},
      {"flat", Heuristic::kFlatTree},
      {"hybrid", Heuristic::kHybrid},
      {"random", Heuristic::kRandom}};
  for (const auto& [name, heuristic] : rows) {
    std::printf("%-22s%8.1f\n", name, difference(with(heuristic, 2), steepest));
    std::fflush(stdout);
  }
}

/// Pieces of an unfolding that is cut wherever a panel would overlap one of its piece.
int pieces_split_at_overlaps(const RootedTree& tree,
                             const std::vector<std::array<int, 2>>& overlaps) {
  std::vector<std::vector<int>> partners(tree.order.size());
  for (const auto& [a, b] : overlaps) {
    partners[a].push_back(b);
    partners[b].push_back(a);
  }
  std::vector<int> piece(tree.order.size(), -1);
  int pieces = 0;
  for (const int panel : tree.order) {
    const int parent = tree.parent[panel];
    const auto collides = [&](int other) { return piece[other] == piece[parent]; };
    const bool starts =
        parent == -1 || std::any_of(partners[panel].begin(), partners[panel].end(), collides);
    piece[panel] = starts ? pieces++ : piece[parent];
  }
  return pieces;
}

/// The fewest pieces of 60 steepest-edge and flat-tree unfoldings, split at their overlaps.
int pieces_by_splitting(const Mesh& mesh) {
  const DualGraph graph = build_dual_graph(mesh);
  const HeuristicWeights weights(mesh, graph);
  Random random(1);
  const std::vector<Vec3> directions = make_directions(mesh, DirectionSet::kRandom, 60, random);
  int fewest = graph.panel_count();
  for (int run = 0; run < static_cast<int>(directions.size()); ++run) {
    const RootedTree tree = hang_tree(
        graph, heuristic_tree(weights, graph, Heuristic::kHybrid, directions[run], run, random));
    const int pieces =
        pieces_split_at_overlaps(tree, overlapping_panels(graph, lay_out(graph, tree)));
    fewest = std::min(fewest, pieces);
  }
  return fewest;
}

void study_pieces() {
  std::puts(
      "\nTable 3: pieces. Asked for 9; by splitting the best of 60 unfoldings at its overlaps; by "
      "one-net search\n(published: snail 574 5(5), other tools 5 and 1; triceratops 1000 11(11), "
      "36, 5; "
      "squirtle 1718 6(6), 18, 4;\nangel 2000 16(11), 42, 14; monkey 2000 10(10), 50, 13)");
  std::printf("%-22s%8s%8s%8s%8s\n", "model", "parts", "pieces", "split", "one net");
  for (const int faces : {574, 1000, 2000}) {
    for (const char* name : kModels) {
      const auto path = model_file(name, faces);
      const auto parts = result_of(path, {.parts = 9});
      const auto whole = result_of(path, {.parts = 1, .folding = FoldingMode::kOff});
      std::printf("%-22s%8d%8zu%8d%8zu\n", path.filename().c_str(), parts->parts,
                  parts->pieces.size(), pieces_by_splitting(parts->mesh), whole->pieces.size());
      std::fflush(stdout);
    }
  }
}

/// Shares of mountain folds among those that are not flat.
struct Folds {
  int mountains = 0, valleys = 0;

  void add(const Net& net) {
    for (const NetEdge& edge : net.edges) {
      mountains += edge.assignment == Assignment::kMountain;
      valleys += edge.assignment == Assignment::kValley;
    }
  }
  double share() const { return 100.0 * mountains / std::max(1, mountains + valleys); }
};

void study_craft() {
  std::puts(
      "\nFig. 9 and section 5.2: areas of the pieces, and folds that are mountains; 9 parts, 1000 "
      "faces");
  std::printf("%-12s%14s%14s%14s%14s\n", "model", "area spread %", "largest %", "mountains %",
              "whole model %");
  for (const char* name : kModels) {
    const auto path = model_file(name, 1000);
    const auto parts = result_of(path, {.parts = 9});
    const auto whole = result_of(path, {.parts = 1, .folding = FoldingMode::kOff});
    Folds in_parts, in_whole;
    for (const Piece& piece : whole->pieces) in_whole.add(piece.net);
    std::vector<double> areas;
    double total = 0;
    for (const Piece& piece : parts->pieces) {
      in_parts.add(piece.net);
      double area = 0;
      for (const int face : piece.net.faces) area += face_area(parts->mesh, face);
      areas.push_back(area);
      total += area;
    }
    const double mean = total / static_cast<double>(areas.size());
    double variance = 0;
    for (const double area : areas) variance += (area - mean) * (area - mean);
    variance /= static_cast<double>(areas.size());
    std::printf("%-12s%14.0f%14.0f%14.1f%14.1f\n", name, 100 * std::sqrt(variance) / mean,
                100 * *std::max_element(areas.begin(), areas.end()) / total, in_parts.share(),
                in_whole.share());
    std::fflush(stdout);
  }
}

}  // namespace

int main() {
  if (testing::files_below("models/organic").empty()) {
    std::puts("studies: no shared models");
    return 0;
  }
  study_runs();
  study_heuristics();
  study_pieces();
  study_craft();
  return 0;
}
