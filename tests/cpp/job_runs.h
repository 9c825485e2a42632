#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <set>
#include <string>

#include "meshes.h"
#include "pipeline/job.h"
#include "result_faults.h"

/// Jobs that are run to their end, and what is asked of every one of them.
namespace foldwright::testing {

/// Microseconds' worth of work in a step, unless a test is about steps.
inline constexpr std::int64_t kSlice = 100000;

inline std::vector<std::byte> to_bytes(const std::string& text) {
  const auto bytes = std::as_bytes(std::span(text));
  return {bytes.begin(), bytes.end()};
}

/// What a job told, and how it ended.
struct Outcome {
  Events events;
  std::shared_ptr<const JobResult> result;

  template <class Kind>
  std::vector<Kind> all() const {
    std::vector<Kind> found;
    for (const Event& event : events) {
      if (const auto* kind = std::get_if<Kind>(&event)) found.push_back(*kind);
    }
    return found;
  }

  /// Codes of the result's notices; what was repaired is told by such events as well.
  std::multiset<std::string> notices() const {
    std::multiset<std::string> codes;
    for (const Notice& notice : result->notices) codes.insert(notice.code);
    return codes;
  }
};

inline void append(Outcome& outcome, Events events) {
  std::ranges::move(events, std::back_inserter(outcome.events));
}

/// The end of every job: the last event says how it ended, and nothing comes after it.
inline void finish(Outcome& outcome, Job& job) {
  EXPECT_TRUE(job.finished());
  EXPECT_TRUE(job.step(kSlice).empty());
  EXPECT_EQ(outcome.all<DoneEvent>().size() + outcome.all<ErrorEvent>().size(), 1u);
  ASSERT_FALSE(outcome.events.empty());
  if (const auto* done = std::get_if<DoneEvent>(&outcome.events.back())) {
    outcome.result = done->result;
  } else {
    EXPECT_TRUE(std::holds_alternative<ErrorEvent>(outcome.events.back()));
  }
}

inline Outcome run_job(Job job, std::int64_t slice = kSlice) {
  Outcome outcome;
  while (!job.finished()) append(outcome, job.step(slice));
  finish(outcome, job);
  return outcome;
}

inline Outcome run_file(const std::string& text, const std::string& name, const JobOptions& options,
                        std::int64_t slice = kSlice) {
  return run_job(Job({{name, to_bytes(text)}}, options), slice);
}

inline Outcome run(const Mesh& mesh, const JobOptions& options = {}, std::int64_t slice = kSlice) {
  return run_file(obj_of(mesh), "model.obj", options, slice);
}

inline void expect_sound(const Outcome& outcome) {
  if (outcome.result == nullptr) {
    FAIL() << describe(outcome.all<ErrorEvent>().at(0).message);
  }
  EXPECT_EQ(fault_of(*outcome.result), "");
}

}  // namespace foldwright::testing
