#pragma once

#include <optional>

#include "pipeline/stage.h"

namespace foldwright {

/// From the bytes of a model file to nets on sheets: runs the stages in order, their tasks one
/// after the other, in steps of a few milliseconds.
///
/// The same bytes, name and options give the same result, however the work is sliced.
class Job {
 public:
  Job(std::vector<std::byte> file, std::string file_name, const JobOptions& options);

  /// Does about `work` microseconds' worth and tells what happened. The last event of a job is
  /// `DoneEvent` or `ErrorEvent`; after it nothing more happens. Never throws: bad input and
  /// exhausted memory become an `ErrorEvent`. A stage's own work (reading, an eigenvalue solve) is
  /// not sliced.
  Events step(std::int64_t work);

  bool finished() const { return finished_; }

 private:
  void advance(std::int64_t work, Events& events);
  void run_task(std::int64_t work, Events& events);
  void report_progress(Events& events);

  JobState state_;
  std::vector<std::unique_ptr<Stage>> stages_;
  std::size_t current_ = 0;
  enum class Phase { kAnnounce, kBegin, kTasks } phase_ = Phase::kAnnounce;
  bool finished_ = false;
  TaskQueue queue_;
  std::optional<TaskRunner> running_;
  double progress_ = 0;
};

}  // namespace foldwright
