#pragma once

#include <optional>

#include "pipeline/stage.h"

namespace foldwright {

/// From a model's files to nets on sheets: runs the stages in order and cuts their
/// parallel work into tasks.
///
/// The same files, options and start give the same result, whoever runs the tasks, in
/// whatever order and slices. None of the functions throws: bad input and exhausted memory become
/// an `ErrorEvent`. The last event of a job is `DoneEvent`, `CancelledEvent` or `ErrorEvent`; after
/// it nothing more happens.
class Job {
 public:
  /// With a `start` the job changes an earlier result: it learns and searches only what the edits
  /// name, and all other parts keep their nets and motions, bit by bit. The options that decide the
  /// mesh must be those of the earlier job; `JobOptions::parts` is not read.
  /// Which of the files is the model, `find_model` says. What jobs that share a memory have done
  /// before is not done again; none of them may run beside another. \pre there is a file
  Job(std::vector<ModelFile> files, const JobOptions& options, std::optional<JobStart> start = {},
      std::shared_ptr<JobMemory> memory = std::make_shared<JobMemory>());

  /// Runs everything here: does about `work` microseconds' worth and tells what happened. A
  /// stage's own work (reading, an eigenvalue solve) is not sliced.
  Events step(std::int64_t work);

  /// For a host that runs the tasks elsewhere: one step of the job's own work. Nothing to do, and
  /// no events, while tasks are waiting or out.
  Events advance();
  /// The next task to run, if one waits.
  std::optional<Task> take_task();
  /// Hands in what a task that is out tells.
  Events report(int task, TaskStatus status);
  /// Hands in a task's result.
  Events complete(int task, TaskResult result);

  /// Tells what there is, once every part has a net and before the job lays them out for good; no
  /// events at other times, or where memory does not suffice. Changes nothing of what the job comes
  /// to. Takes some milliseconds.
  Events draft() const;

  /// Ends the job; the event keeps the nets found so far. Takes some milliseconds.
  Events cancel();

  bool finished() const { return finished_; }

 private:
  template <class Action>
  Events guarded(Action&& action);
  void do_own_step(Events& events);
  void run_task(std::int64_t work, Events& events);
  void report_progress(Events& events);

  JobState state_;
  std::vector<std::unique_ptr<Stage>> stages_;
  std::size_t current_ = 0;
  enum class Phase { kAnnounce, kBegin, kTasks } phase_ = Phase::kAnnounce;
  bool finished_ = false;
  TaskQueue queue_;
  Running running_;
  std::optional<TaskRunner> own_runner_;
  double progress_ = 0;
};

}  // namespace foldwright
