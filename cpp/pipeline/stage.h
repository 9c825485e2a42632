#pragma once

#include <deque>
#include <memory>

#include "pipeline/state.h"

namespace foldwright {

/// Tasks that wait to be run, in order, with their numbers.
class TaskQueue {
 public:
  /// Adds a task and returns its number.
  int add(std::shared_ptr<const Surface> surface, std::vector<int> panels, Work work);
  bool empty() const { return waiting_.empty(); }
  Task take();

 private:
  std::deque<Task> waiting_;
  int next_id_ = 0;
};

/// Last status of every task that is being run, by its number.
using Running = std::map<int, TaskStatus>;

/// A task that has been run to its end.
struct CompletedTask {
  int id;
  TaskResult result;
};

/// One named step of a job: some work of its own, and parallel work cut into tasks.
///
/// `prepare` runs until it is done; then `begin` runs once and may queue tasks; `complete` takes
/// their results, in whatever order they come, and may queue more; when no task is left, `go_on`
/// runs until it is done, and then `end` once. What comes out must not depend on the order of the
/// results.
class Stage {
 public:
  virtual ~Stage() = default;
  virtual StageId id() const = 0;
  /// Does some milliseconds of work that has to be done before tasks are known; true when none is
  /// left.
  virtual bool prepare(JobState&) { return true; }
  virtual void begin(JobState& state, TaskQueue& queue, Events& events) = 0;
  virtual void complete(JobState&, TaskQueue&, CompletedTask, Events&) {}
  /// Does some milliseconds of work that cannot be split into tasks; true when none is left.
  virtual bool go_on(JobState&, Events&) { return true; }
  virtual void end(JobState&, Events&) {}
  /// Moves the nets that are finished to the state, when the job is cancelled in this stage.
  virtual void salvage(JobState&) {}
  /// Called with each status of a task; `running` has it already.
  virtual void watch(int /*task*/, const Running& /*running*/, Events&) {}
  /// Share of the stage done, in [0, 1].
  virtual double progress(const JobState&, const Running& running) const = 0;
};

std::unique_ptr<Stage> make_read_stage(std::vector<ModelFile> files);
std::unique_ptr<Stage> make_learn_stage();
std::unique_ptr<Stage> make_cluster_stage();
std::unique_ptr<Stage> make_search_stage();
std::unique_ptr<Stage> make_compact_stage();
std::unique_ptr<Stage> make_paper_stage();

}  // namespace foldwright
