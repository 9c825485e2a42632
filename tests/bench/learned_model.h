#pragma once

#include <cstring>
#include <filesystem>
#include <utility>

#include "pipeline/stage.h"
#include "shared_models.h"

namespace foldwright::testing {

/// A model with what was learned about it: the first two stages of a job, on one thread.
inline JobState learn_model(const std::filesystem::path& file, const JobOptions& options) {
  JobState state;
  const std::string bytes = bytes_of(file);
  ModelFile model;
  model.name = file.filename().string();
  model.bytes.resize(bytes.size());
  std::memcpy(model.bytes.data(), bytes.data(), bytes.size());
  state.options = options;
  TaskQueue queue;
  Events events;
  make_read_stage({std::move(model)})->begin(state, queue, events);
  const auto stage = make_learn_stage();
  stage->begin(state, queue, events);
  while (!queue.empty()) {
    TaskRunner runner(queue.take());
    while (!runner.step(1'000'000)) continue;
    stage->complete(state, queue, {runner.task().id, runner.result()}, events);
  }
  return state;
}

/// Parts of a learned model per face of its mesh: the third stage. `state` is a copy, so that one
/// learning serves many numbers of parts; its first component gets as many as `parts` says.
inline std::vector<int> parts_of(JobState state, int parts) {
  state.parts.components.front().parts = parts;
  TaskQueue queue;
  Events events;
  make_cluster_stage()->begin(state, queue, events);
  return state.parts.labels;
}

}  // namespace foldwright::testing
