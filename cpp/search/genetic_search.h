#pragma once

#include <cstdint>
#include <unordered_map>

#include "geometry/random.h"
#include "unfold/heuristics.h"
#include "unfold/layout.h"

namespace foldwright {

/// Settings of the genetic search: population, offspring, generations and the two factors as in the
/// paper [4.3, 5.1]; what it leaves open follows the settings that its authors published later.
struct GeneticOptions {
  int population = 500;
  int offspring = 40;  ///< per generation; they replace the worst
  int generations = 2000;
  int tournament = 7;           ///< a parent is the fittest of so many drawn ones
  double crossover = 0.4;       ///< chance of each gene to come from the second parent
  double mutation = 0.01;       ///< chance of each gene to change
  double step = 0.3;            ///< standard deviation of a change
  double overlap_cost = 1;      ///< lambda_o
  double hyperbolic_cost = 10;  ///< lambda_l
  std::uint64_t seed = 1;
};

/// How bad an unfolding is [paper, 4.3].
struct Fitness {
  int overlaps = 0;    ///< N_o: pairs of panels that overlap
  int hyperbolic = 0;  ///< N_l: hyperbolic vertices around which faces overlap each other

  /// -(lambda_o N_o + lambda_l N_l); 0 for a net.
  double value(const GeneticOptions& options) const {
    return -(options.overlap_cost * overlaps + options.hyperbolic_cost * hyperbolic);
  }
};

/// Evaluates fold trees of one graph.
class FitnessFunction {
 public:
  /// Both must outlive this object.
  FitnessFunction(const Mesh& mesh, const DualGraph& graph);

  Fitness operator()(std::span<const int> folds) const;

 private:
  const DualGraph* graph_;
  std::vector<std::vector<int>> hyperbolic_of_panel_;  ///< hyperbolic inner vertices, ascending
};

/// Evolves weights of dual edges until the minimum spanning tree is a net [paper, 4.3]: one
/// evolution from one seed.
///
/// A gene is the weight of one hinge, in [0, 1]. The first individuals come from steepest edge,
/// flat tree, inverted flat tree and random weights in random directions. The best fitness never
/// falls.
class GeneticSearch {
 public:
  /// Both must outlive this object. \pre graph is connected
  GeneticSearch(const Mesh& mesh, const DualGraph& graph, const GeneticOptions& options = {});

  enum class State { kRunning, kFound, kGaveUp };

  /// Does up to `work` units of work (a unit is about a microsecond) and says where it stands.
  State step(std::int64_t work);

  State state() const { return state_; }
  const FoldTree& best() const { return best_folds_; }
  Fitness best_fitness() const { return best_; }
  double best_value() const { return best_.value(options_); }
  int generation() const { return generation_; }
  std::int64_t evaluations() const { return evaluations_; }
  /// Share of the generations done, in [0, 1].
  double progress() const;

 private:
  struct Individual {
    std::vector<float> genes;
    double fitness;
  };

  void add_initial();
  void add_offspring();
  void finish_generation();
  Individual evaluated(std::vector<float> genes);
  const Individual& draw_parent();

  const DualGraph* graph_;
  GeneticOptions options_;
  HeuristicWeights weights_;
  FitnessFunction fitness_;
  Random random_;
  std::vector<Individual> population_, offspring_;
  /// Fitness by hash of the fold tree: late offspring mostly repeat known trees.
  std::unordered_map<std::uint64_t, Fitness> known_;
  FoldTree best_folds_;
  Fitness best_;
  bool has_best_ = false;
  int generation_ = 0;
  std::int64_t evaluations_ = 0;
  State state_ = State::kRunning;
};

}  // namespace foldwright
