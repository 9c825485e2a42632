#include "pipeline/job.h"

#include <algorithm>
#include <exception>
#include <new>

#include "mesh/input_error.h"

namespace foldwright {
namespace {

/// Share of a usual job's time that each stage takes, in the order of `StageId`.
constexpr double kStageShares[] = {0.04, 0.48, 0.12, 0.33, 0.03};

}  // namespace

int TaskQueue::add(std::shared_ptr<const Surface> surface, std::vector<int> panels, Work work) {
  waiting_.push_back({next_id_, std::move(surface), std::move(panels), std::move(work)});
  return next_id_++;
}

Task TaskQueue::take() {
  Task task = std::move(waiting_.front());
  waiting_.pop_front();
  return task;
}

Job::Job(std::vector<std::byte> file, std::string file_name, const JobOptions& options) {
  state_.file = std::move(file);
  state_.file_name = std::move(file_name);
  state_.options = options;
  stages_.push_back(make_read_stage());
  stages_.push_back(make_learn_stage());
  stages_.push_back(make_cluster_stage());
  stages_.push_back(make_search_stage());
  stages_.push_back(make_paper_stage());
}

Events Job::step(std::int64_t work) {
  Events events;
  if (finished_) return events;
  try {
    advance(work, events);
  } catch (const InputError& error) {
    events.push_back(ErrorEvent{error.code(), error.what()});
  } catch (const std::bad_alloc&) {
    events.push_back(ErrorEvent{"out-of-memory", "the model needs more memory than there is"});
  } catch (const std::exception& error) {
    events.push_back(ErrorEvent{"internal", std::string("internal error: ") + error.what()});
  }
  if (!events.empty() && std::holds_alternative<ErrorEvent>(events.back())) finished_ = true;
  return events;
}

void Job::advance(std::int64_t work, Events& events) {
  Stage& stage = *stages_[current_];
  if (phase_ == Phase::kAnnounce) {
    // A step of its own, so that the stage's name is out before work that is not sliced.
    phase_ = Phase::kBegin;
  } else if (phase_ == Phase::kBegin) {
    stage.begin(state_, queue_, events);
    phase_ = Phase::kTasks;
  } else if (running_ || !queue_.empty()) {
    run_task(work, events);
  } else {
    stage.end(state_, events);
    phase_ = Phase::kAnnounce;
    if (++current_ < stages_.size()) return;
    finished_ = true;
    events.push_back(DoneEvent{std::make_shared<const JobResult>(std::move(state_.result))});
    return;
  }
  report_progress(events);
}

void Job::run_task(std::int64_t work, Events& events) {
  if (!running_) running_.emplace(queue_.take());
  const bool done = running_->step(work);
  stages_[current_]->watch(state_, *running_, events);
  if (!done) return;
  const int id = running_->task().id;
  TaskResult result = running_->result();
  running_.reset();
  stages_[current_]->complete(state_, queue_, id, std::move(result), events);
}

void Job::report_progress(Events& events) {
  double done = 0;
  for (std::size_t i = 0; i < current_; ++i) done += kStageShares[i];
  const Stage& stage = *stages_[current_];
  if (phase_ == Phase::kTasks) {
    done += kStageShares[current_] * stage.progress(state_, running_ ? &*running_ : nullptr);
  }
  progress_ = std::clamp(done, progress_, 1.0);
  events.push_back(StageEvent{stage.id(), progress_});
}

}  // namespace foldwright
