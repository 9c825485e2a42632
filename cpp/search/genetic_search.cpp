#include "search/genetic_search.h"

#include <algorithm>
#include <set>

#include "search/hyperbolic.h"
#include "unfold/directions.h"

namespace foldwright {
namespace {

/// 64-bit FNV-1a over the folds.
std::uint64_t hash_of(std::span<const int> folds) {
  std::uint64_t hash = 0xcbf29ce484222325ull;
  for (const int fold : folds) hash = (hash ^ static_cast<std::uint64_t>(fold)) * 0x100000001b3ull;
  return hash;
}

/// Scales weights into [0, 1], keeping their order.
std::vector<float> to_genes(const std::vector<double>& weights) {
  std::vector<float> genes;
  if (weights.empty()) return genes;
  const auto [low, high] = std::minmax_element(weights.begin(), weights.end());
  const double scale = *high > *low ? 1 / (*high - *low) : 0;
  for (const double weight : weights) genes.push_back(static_cast<float>((weight - *low) * scale));
  return genes;
}

}  // namespace

FitnessFunction::FitnessFunction(const Mesh& mesh, const DualGraph& graph)
    : graph_(&graph), hyperbolic_of_panel_(hyperbolic_vertices_of_panels(mesh, graph)) {}

Fitness FitnessFunction::operator()(std::span<const int> folds) const {
  const auto pairs = overlapping_panels(*graph_, lay_out(*graph_, hang_tree(*graph_, folds)));
  std::set<int> local;
  for (const auto& [a, b] : pairs) {
    std::set_intersection(hyperbolic_of_panel_[a].begin(), hyperbolic_of_panel_[a].end(),
                          hyperbolic_of_panel_[b].begin(), hyperbolic_of_panel_[b].end(),
                          std::inserter(local, local.end()));
  }
  return {static_cast<int>(pairs.size()), static_cast<int>(local.size())};
}

GeneticSearch::GeneticSearch(const Mesh& mesh, const DualGraph& graph,
                             const GeneticOptions& options)
    : graph_(&graph),
      options_(options),
      weights_(mesh, graph),
      fitness_(mesh, graph),
      random_(options.seed) {}

GeneticSearch::State GeneticSearch::step(std::int64_t work) {
  // Spanning tree, layout and overlaps of one individual: about a quarter microsecond a panel.
  const std::int64_t cost = 1 + graph_->panel_count() / 4;
  for (; state_ == State::kRunning && work > 0; work -= cost) {
    if (static_cast<int>(population_.size()) < options_.population) {
      add_initial();
    } else {
      add_offspring();
    }
  }
  return state_;
}

double GeneticSearch::progress() const {
  return static_cast<double>(generation_) / std::max(1, options_.generations);
}

void GeneticSearch::add_initial() {
  const Vec3 direction = random_direction(random_);
  std::vector<double> weights;
  switch (population_.size() % 4) {
    case 0:
      weights = weights_.steepest_edge(direction);
      break;
    case 1:
      weights = weights_.flat_tree(direction);
      break;
    case 2:
      weights = weights_.flat_tree(direction);
      for (double& weight : weights) weight = 1 - weight;
      break;
    default:
      weights = weights_.weights(Heuristic::kRandom, direction, 0, random_);
  }
  population_.push_back(evaluated(to_genes(weights)));
}

/// The fittest of some individuals drawn with replacement; the first drawn among equals.
const GeneticSearch::Individual& GeneticSearch::draw_parent() {
  const Individual* best = nullptr;
  for (int i = 0; i < options_.tournament; ++i) {
    const Individual& drawn = population_[random_.below(options_.population)];
    if (best == nullptr || drawn.fitness > best->fitness) best = &drawn;
  }
  return *best;
}

void GeneticSearch::add_offspring() {
  std::vector<float> genes = draw_parent().genes;
  const std::vector<float>& second = draw_parent().genes;
  for (std::size_t i = 0; i < genes.size(); ++i) {
    if (random_.uniform() < options_.crossover) genes[i] = second[i];
    if (random_.uniform() >= options_.mutation) continue;
    const double changed = genes[i] + options_.step * random_.normal();
    genes[i] = static_cast<float>(std::clamp(changed, 0.0, 1.0));
  }
  offspring_.push_back(evaluated(std::move(genes)));
  if (static_cast<int>(offspring_.size()) == options_.offspring) finish_generation();
}

/// The offspring take the places of the worst.
void GeneticSearch::finish_generation() {
  std::stable_sort(population_.begin(), population_.end(),
                   [](const Individual& a, const Individual& b) { return a.fitness > b.fitness; });
  const std::size_t replaced = std::min(offspring_.size(), population_.size());
  std::move(offspring_.begin(), offspring_.begin() + static_cast<std::ptrdiff_t>(replaced),
            population_.end() - static_cast<std::ptrdiff_t>(replaced));
  offspring_.clear();
  ++generation_;
  if (state_ == State::kRunning && generation_ >= options_.generations) state_ = State::kGaveUp;
}

GeneticSearch::Individual GeneticSearch::evaluated(std::vector<float> genes) {
  const std::vector<double> weights(genes.begin(), genes.end());
  FoldTree folds = minimum_spanning_tree(*graph_, weights);
  const auto [known, is_new] = known_.try_emplace(hash_of(folds));
  if (is_new) known->second = fitness_(folds);
  ++evaluations_;
  const Fitness fitness = known->second;
  const double value = fitness.value(options_);
  if (!has_best_ || value > best_.value(options_)) {
    has_best_ = true;
    best_ = fitness;
    best_folds_ = std::move(folds);
    if (best_.overlaps == 0) state_ = State::kFound;
  }
  return {std::move(genes), value};
}

}  // namespace foldwright
