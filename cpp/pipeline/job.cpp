#include "pipeline/job.h"

#include <algorithm>
#include <exception>
#include <new>

#include "mesh/input_error.h"

namespace foldwright {
namespace {

/// What there is to know of a stage beside its work.
struct StageFacts {
  const char* name;
  double share;  ///< of a usual job's time
};

/// In the order of `StageId`.
constexpr StageFacts kStages[] = {{"read", 0.02},  {"learn", 0.2},    {"cluster", 0.08},
                                  {"search", 0.2}, {"compact", 0.45}, {"paper", 0.05}};

/// What whatever nets there are come to on sheets.
std::shared_ptr<const JobResult> laid_out_in_a_hurry(JobState state) {
  state.in_a_hurry = true;
  TaskQueue unused;
  Events unheard;
  const std::unique_ptr<Stage> paper = make_paper_stage();
  paper->begin(state, unused, unheard);
  while (!paper->go_on(state, unheard)) {
  }
  paper->end(state, unheard);
  return std::make_shared<const JobResult>(*std::move(state.result));
}

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

Job::Job(std::vector<ModelFile> files, const JobOptions& options, std::optional<JobStart> start,
         std::shared_ptr<JobMemory> memory) {
  state_.memory = std::move(memory);
  state_.options = options;
  state_.start = std::move(start);
  stages_.push_back(make_read_stage(std::move(files)));
  stages_.push_back(make_learn_stage());
  stages_.push_back(make_cluster_stage());
  stages_.push_back(make_search_stage());
  stages_.push_back(make_compact_stage());
  stages_.push_back(make_paper_stage());
}

/// Runs an action and turns what it throws into the job's last event.
template <class Action>
Events Job::guarded(Action&& action) {
  Events events;
  if (finished_) return events;
  const auto fail = [&](Message message, std::vector<int> faces = {}) {
    events.push_back(ErrorEvent{std::move(message), std::move(faces)});
    finished_ = true;
  };
  const char* stage = kStages[current_].name;
  try {
    action(events);
  } catch (const InputError& error) {
    fail(error.message(), error.faces());
  } catch (const std::bad_alloc&) {
    fail({"out-of-memory", {{"what", stage}}});
  } catch (const std::exception& error) {
    fail({"internal", {{"what", stage}, {"detail", error.what()}}});
  }
  return events;
}

Events Job::step(std::int64_t work) {
  return guarded([&](Events& events) {
    if (own_runner_ || !queue_.empty()) {
      run_task(work, events);
    } else {
      do_own_step(events);
    }
  });
}

Events Job::advance() {
  return guarded([&](Events& events) {
    if (queue_.empty() && running_.empty()) do_own_step(events);
  });
}

std::optional<Task> Job::take_task() {
  if (finished_ || queue_.empty()) return std::nullopt;
  Task task = queue_.take();
  running_[task.id] = {};
  return task;
}

Events Job::report(int task, TaskStatus status) {
  return guarded([&](Events& events) {
    running_[task] = std::move(status);
    stages_[current_]->watch(task, running_, events);
    report_progress(events);
  });
}

Events Job::complete(int task, TaskResult result) {
  return guarded([&](Events& events) {
    running_.erase(task);
    stages_[current_]->complete(state_, queue_, {task, std::move(result)}, events);
    report_progress(events);
  });
}

Events Job::draft() const {
  const bool has_all = current_ > static_cast<std::size_t>(StageId::kSearch);
  if (finished_ || !has_all || state_.nets.found.empty() || state_.result) return {};
  try {
    return {DraftEvent{laid_out_in_a_hurry(state_)}};
  } catch (const std::bad_alloc&) {
    return {};
  }
}

Events Job::cancel() {
  return guarded([&](Events& events) {
    finished_ = true;
    own_runner_.reset();
    stages_[current_]->salvage(state_);
    if (state_.nets.found.empty()) {
      events.push_back(CancelledEvent{});
      return;
    }
    // The last stage may have laid them out already.
    events.push_back(
        CancelledEvent{state_.result ? std::make_shared<const JobResult>(*std::move(state_.result))
                                     : laid_out_in_a_hurry(std::move(state_))});
  });
}

void Job::do_own_step(Events& events) {
  Stage& stage = *stages_[current_];
  if (phase_ == Phase::kAnnounce) {
    // A step of its own, so that the stage's name is out before work that is not sliced.
    phase_ = Phase::kBegin;
  } else if (phase_ == Phase::kBegin) {
    if (!stage.prepare(state_)) return report_progress(events);
    stage.begin(state_, queue_, events);
    phase_ = Phase::kTasks;
  } else if (stage.go_on(state_, events)) {
    stage.end(state_, events);
    phase_ = Phase::kAnnounce;
    if (++current_ == stages_.size()) {
      finished_ = true;
      events.push_back(DoneEvent{std::make_shared<const JobResult>(*std::move(state_.result))});
    }
    return;
  }
  report_progress(events);
}

void Job::run_task(std::int64_t work, Events& events) {
  if (!own_runner_) own_runner_.emplace(*take_task());
  const int id = own_runner_->task().id;
  const bool done = own_runner_->step(work);
  running_[id] = own_runner_->status(false);
  stages_[current_]->watch(id, running_, events);
  if (done) {
    TaskResult result = own_runner_->result();
    own_runner_.reset();
    running_.erase(id);
    stages_[current_]->complete(state_, queue_, {id, std::move(result)}, events);
  }
  report_progress(events);
}

void Job::report_progress(Events& events) {
  double done = 0;
  for (std::size_t i = 0; i < current_; ++i) done += kStages[i].share;
  const Stage& stage = *stages_[current_];
  if (phase_ == Phase::kTasks) {
    done += kStages[current_].share * stage.progress(state_, running_);
  }
  progress_ = std::clamp(done, progress_, 1.0);
  events.push_back(StageEvent{stage.id(), progress_});
}

}  // namespace foldwright
