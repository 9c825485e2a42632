#pragma once

#include <map>
#include <memory>
#include <variant>
#include <vector>

#include "fold/planner.h"
#include "paper/craft_cost.h"
#include "search/border_exchange.h"
#include "search/genetic_search.h"
#include "search/net_annealing.h"
#include "search/tree_search.h"
#include "segment/foldability.h"

namespace foldwright {

/// A mesh and its dual graph, shared by all tasks on it.
struct Surface {
  int key;  ///< names it within its job
  Mesh mesh;
  DualGraph graph;              ///< as the locks leave it
  std::vector<EdgeLock> locks;  ///< see `lock_edges`
};
std::shared_ptr<const Surface> make_surface(int key, Mesh mesh, std::vector<EdgeLock> locks = {});

/// Some learning runs.
struct LearnTask {
  LearnOptions options;
  int first_run, last_run;
};

/// One net search from one seed, on spanning trees or by evolution.
struct SearchTask {
  TreeSearchOptions options;
  FoldTree initial =
      {};  ///< to start from, of the graph of the task's panels; empty: from heuristics
};
struct GeneticTask {
  GeneticOptions options;
};

/// Border exchange around one part of a component.
struct ExchangeTask {
  PartsSoFar parts;  ///< in panels of the task
  ExchangeOptions options;
};

/// Planning a motion of a given net.
struct PlanTask {
  FoldTree folds;
  double clearance;
  std::uint64_t seed;
};

/// Making a net better to craft.
struct CompactTask {
  FoldTree folds;
  CraftOptions craft;
  AnnealingOptions annealing;
};

using Work = std::variant<LearnTask, SearchTask, GeneticTask, ExchangeTask, PlanTask, CompactTask>;

/// A unit of parallel work as a plain value: any instance of the engine that has the surface can
/// run it and gets the same result.
struct Task {
  int id;
  std::shared_ptr<const Surface> surface;
  std::vector<int> panels;  ///< of the surface, connected, ascending
  Work work;
};

struct SearchResult {
  FoldTree folds;  ///< of the graph of the task's panels; a net if `overlaps` is 0
  int overlaps;
  int shortfall;        ///< conflicts, in the plane and in space, that keep it from what was asked
  bool folds_straight;  ///< certified
  std::int64_t moves;   ///< of a tree search
  int generations;      ///< of a genetic search
};
struct ExchangeResult {
  bool found;
  std::vector<int> labels;          ///< per panel of the task, after the exchange
  std::map<int, FoldTree> changed;  ///< best trees of the parts whose panels changed
  std::map<int, int> shortfalls;    ///< left, of each other part without what was asked
  std::int64_t moves;
};
struct PlanResult {
  FoldMotion motion;
};
struct CompactResult {
  FoldTree folds;
  std::vector<BorderRoom> borders;  ///< room that the net has at its border
  std::int64_t moves;
};
using TaskResult =
    std::variant<FoldabilityCounts, SearchResult, ExchangeResult, PlanResult, CompactResult>;

/// Where a net search stands after a generation, or a batch of moves.
struct SearchStatus {
  double best;  ///< fitness
  int overlaps, hyperbolic;
};

/// A net under search, to be looked at.
struct NetPicture {
  std::vector<float> corners;             ///< three corners (x, y) per face, model units
  std::vector<int> sources;               ///< per face: the mesh face
  std::vector<std::uint8_t> overlapping;  ///< per face: 1 if its panel overlaps another
};

/// What a task under way tells.
struct TaskStatus {
  double progress = 0;                    ///< in [0, 1]; an estimate for searches
  int runs = 0;                           ///< learning runs done
  std::vector<SearchStatus> generations;  ///< since the last status
  std::optional<NetPicture> net;          ///< of the best tree, if asked for
};

/// Runs one task in steps.
class TaskRunner {
 public:
  explicit TaskRunner(Task task);
  TaskRunner(const TaskRunner&) = delete;
  TaskRunner& operator=(const TaskRunner&) = delete;

  /// Does about `work` microseconds' worth; true when the task is done.
  bool step(std::int64_t work);
  /// Whether the next step is spent on how a net folds up: on making one fold that lies flat
  /// without overlaps, or on planning its motion.
  bool is_folding() const;
  /// What has happened since the last call.
  TaskStatus status(bool with_net);
  /// \pre `step` returned true
  TaskResult result() const;

  const Task& task() const { return task_; }

 private:
  void note_generation();
  const FoldTree* best_tree() const;

  Task task_;
  DualGraph graph_;
  std::optional<Foldable> foldable_;  ///< for planning
  /// Made once `graph_`, which they refer to, stands.
  std::variant<std::monostate, FoldabilityLearner, TreeSearch, GeneticSearch, BorderExchange,
               MotionPlanner, NetAnnealing>
      run_;
  std::vector<SearchStatus> generations_;
  int last_generation_ = 0;
};

}  // namespace foldwright
