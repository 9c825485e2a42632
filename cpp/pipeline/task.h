#pragma once

#include <memory>
#include <variant>
#include <vector>

#include "search/border_exchange.h"
#include "search/tree_search.h"
#include "segment/foldability.h"

namespace foldwright {

/// A mesh and its dual graph, shared by all tasks on it.
struct Surface {
  Mesh mesh;
  DualGraph graph;
};
std::shared_ptr<const Surface> make_surface(Mesh mesh);

/// Some learning runs.
struct LearnTask {
  LearnOptions options;
  int first_run, last_run;
};

/// One net search from one seed.
struct SearchTask {
  TreeSearchOptions options;
};

/// Border exchange around one part of a component.
struct ExchangeTask {
  PartsSoFar parts;  ///< in panels of the task
  ExchangeOptions options;
};

using Work = std::variant<LearnTask, SearchTask, ExchangeTask>;

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
  std::int64_t moves;
};
struct ExchangeResult {
  bool found;
  std::vector<int> labels;          ///< per panel of the task, after the exchange
  std::map<int, FoldTree> changed;  ///< best trees of the parts whose panels changed
  std::map<int, int> overlaps;      ///< left, of each other part without a net
  std::int64_t moves;
};
using TaskResult = std::variant<FoldabilityCounts, SearchResult, ExchangeResult>;

/// Runs one task in steps.
class TaskRunner {
 public:
  explicit TaskRunner(Task task);

  /// Does about `work` microseconds' worth; true when the task is done.
  bool step(std::int64_t work);
  /// \pre `step` returned true
  TaskResult result() const;

  const Task& task() const { return task_; }
  /// Share done, in [0, 1]; an estimate for searches.
  double progress() const;
  /// Learning runs done; 0 for a search.
  int runs_done() const;
  /// Overlaps of the best tree so far; -1 for a learning task.
  int overlaps() const;

 private:
  Task task_;
  DualGraph graph_;
  // Behind pointers because they refer to `graph_` and are made once it stands.
  std::unique_ptr<FoldabilityLearner> learner_;
  std::unique_ptr<TreeSearch> search_;
  std::unique_ptr<BorderExchange> exchange_;
};

}  // namespace foldwright
