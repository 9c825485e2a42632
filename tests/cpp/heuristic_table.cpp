#include "heuristic_table.h"

#include <cstdio>
#include <span>

#include "meshes.h"
#include "segment/segment.h"
#include "shared_models.h"
#include "trees.h"
#include "unfold/directions.h"

namespace foldwright::testing {
namespace {

constexpr std::pair<const char*, Heuristic> kHeuristics[] = {
    {"steepest edge", Heuristic::kSteepestEdge},
    {"flat tree", Heuristic::kFlatTree},
    {"hybrid", Heuristic::kHybrid},
    {"random", Heuristic::kRandom}};

template <class... Values>
std::string line(const char* format, Values... values) {
  char buffer[120];
  std::snprintf(buffer, sizeof buffer, format, values...);
  return buffer;
}

std::string row(const char* name, std::span<const Unfoldable> surfaces, int runs) {
  const int all = runs * static_cast<int>(surfaces.size());
  std::string text = line("%-16s%8d", name, static_cast<int>(surfaces.size()));
  for (const auto& [_, heuristic] : kHeuristics) {
    int nets = 0;
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
      nets += count_nets(surfaces[i], heuristic, runs, i);
    }
    text += line("%14.1f", 100.0 * nets / all);
  }
  return text + "\n";
}

}  // namespace

std::vector<Unfoldable> convex_hulls(int count) {
  std::vector<Unfoldable> hulls;
  for (int i = 0; i < count; ++i) {
    hulls.push_back(unfoldable(random_hull(static_cast<std::uint64_t>(i), 20 + i % 101)));
  }
  return hulls;
}

std::vector<Unfoldable> organic_parts() {
  constexpr int kParts = 8;
  std::vector<Unfoldable> parts;
  for (const auto& path : files_below("models/organic")) {
    if (!path.stem().string().ends_with("_300")) continue;
    const Unfoldable whole = unfoldable(load(path).mesh);
    const Labels labels = segment(whole.mesh, whole.graph, learn(whole, 100), {.parts = kParts});
    for (int part = 0; part < kParts; ++part) {
      parts.push_back({whole.mesh, restrict_to(whole.graph, panels_of(labels, part))});
    }
  }
  return parts;
}

int count_nets(const Unfoldable& surface, Heuristic heuristic, int runs, std::uint64_t seed) {
  const HeuristicWeights weights(surface.mesh, surface.graph);
  Random random(seed);
  int nets = 0;
  for (int run = 0; run < runs; ++run) {
    const Vec3 direction = random_direction(random);
    const FoldTree folds =
        minimum_spanning_tree(surface.graph, weights.weights(heuristic, direction, run, random));
    nets += overlaps_of(surface.graph, folds).empty();
  }
  return nets;
}

std::string heuristic_table(int hulls, int runs) {
  std::string text = line("%-16s%8s", "nets in percent", "count");
  for (const auto& [name, _] : kHeuristics) text += line("%14s", name);
  text += "\n" + row("convex hulls", convex_hulls(hulls), runs);
  const Unfoldable spikes[] = {unfoldable(star())};
  text += row("star", spikes, 20 * runs);
  const std::vector<Unfoldable> parts = organic_parts();
  if (!parts.empty()) text += row("organic parts", parts, runs);
  return text;
}

}  // namespace foldwright::testing
