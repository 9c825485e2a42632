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

/// One named step of a job: some work of its own, and parallel work cut into tasks.
///
/// `begin` runs once and may queue tasks; `complete` takes each result in the order of the task
/// numbers and may queue more; when all tasks are done, `end` runs once.
class Stage {
 public:
  virtual ~Stage() = default;
  virtual StageId id() const = 0;
  virtual void begin(JobState& state, TaskQueue& queue, Events& events) = 0;
  virtual void complete(JobState&, TaskQueue&, int /*task*/, TaskResult, Events&) {}
  virtual void end(JobState&, Events&) {}
  /// Called while a task runs.
  virtual void watch(const JobState&, const TaskRunner&, Events&) {}
  /// Share of the stage done, in [0, 1], counting `running` as that share of its task.
  virtual double progress(const JobState&, const TaskRunner* running) const = 0;
};

std::unique_ptr<Stage> make_read_stage();
std::unique_ptr<Stage> make_learn_stage();
std::unique_ptr<Stage> make_cluster_stage();
std::unique_ptr<Stage> make_search_stage();
std::unique_ptr<Stage> make_paper_stage();

}  // namespace foldwright
