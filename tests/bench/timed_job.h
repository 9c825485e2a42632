#pragma once

#include <algorithm>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <map>
#include <memory>

#include "pipeline/job.h"
#include "shared_models.h"

namespace foldwright::testing {

/// What a job came to, and how long each of its stages took: in the processor's time, so that
/// whatever else the machine does counts for little.
struct TimedJob {
  std::shared_ptr<const JobResult> result;  ///< null if the model could not be used
  std::map<StageId, double> seconds;        ///< of the processor, so that others do not count
  std::map<StageId, double> longest_step;   ///< how late a cancel may be answered
};

/// Runs a job alone and on one thread.
inline TimedJob run_timed(Job job) {
  TimedJob timed;
  StageId stage = StageId::kRead;
  while (!job.finished()) {
    const std::clock_t start = std::clock();
    const StageId before = stage;
    for (const Event& event : job.step(10000)) {
      if (const auto* at = std::get_if<StageEvent>(&event)) stage = at->stage;
      if (const auto* done = std::get_if<DoneEvent>(&event)) timed.result = done->result;
    }
    const double passed = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    timed.seconds[before] += passed;
    timed.longest_step[before] = std::max(timed.longest_step[before], passed);
  }
  return timed;
}

/// The same on the bytes of a model file.
inline TimedJob run_timed(std::vector<std::byte> file, const std::string& name,
                          const JobOptions& options) {
  return run_timed(Job({{name, std::move(file)}}, options));
}

/// The same of a model file.
inline TimedJob run_timed(const std::filesystem::path& path, const JobOptions& options) {
  const std::string bytes = bytes_of(path);
  std::vector<std::byte> file(bytes.size());
  std::memcpy(file.data(), bytes.data(), bytes.size());
  return run_timed(std::move(file), path.filename().string(), options);
}

}  // namespace foldwright::testing
