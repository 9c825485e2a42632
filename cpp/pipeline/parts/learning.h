#pragma once

#include "pipeline/stage.h"

namespace foldwright {

/// The learning of one component as tasks: on itself, or on a proxy when it is large.
class Learning {
 public:
  /// Chooses the surface and queues its runs.
  Learning(const JobState& state, int component, TaskQueue& queue);

  int component() const { return component_; }
  bool owns(int task) const { return task >= first_task_ && task <= last_task_; }
  /// Adds a task's counts. True when it was the last one: then `finish` gives what was learned.
  bool complete(const FoldabilityCounts& counts);
  Learned finish();
  /// Of the tasks that are complete; empty before the first.
  const FoldabilityCounts& counts() const { return counts_; }

 private:
  int component_;
  int first_task_ = 0, last_task_ = -1;
  int open_tasks_ = 0;
  Learned learned_;
  FoldabilityCounts counts_;
};

}  // namespace foldwright
