// Any small model goes through all stages of a job: to nets that hold all of its faces without
// overlaps, to a refusal, or, where it takes long, to what a cancelled job keeps.

#include <cstdint>
#include <span>
#include <vector>

#include "expect.h"
#include "mesh/input_error.h"
#include "pipeline/job.h"
#include "read/read_model.h"
#include "result_faults.h"

namespace {

using foldwright::fuzz::expect;

// Small enough for some ten runs a second under sanitizers, large enough for all cases of repair.
constexpr int kMostFaces = 48;
constexpr int kMostSteps = 60;
constexpr std::size_t kEvery = 8;  // inputs are compacted, which takes most of a job's time
constexpr std::int64_t kWorkOfStep = 10000;     // microseconds, without sanitizers
constexpr const char* kFileName = "model.obj";  // of bytes that show no format

bool is_small(std::span<const std::byte> bytes) {
  try {
    return foldwright::read_model(bytes, kFileName).face_count() <= kMostFaces;
  } catch (const foldwright::InputError&) {
    return false;
  }
}

void expect_good_end(const foldwright::Event& end) {
  if (const auto* done = std::get_if<foldwright::DoneEvent>(&end)) {
    expect(foldwright::testing::fault_of(*done->result).empty(),
           foldwright::testing::fault_of(*done->result));
  } else if (const auto* error = std::get_if<foldwright::ErrorEvent>(&end)) {
    const auto& message = error->message;
    const std::string text = foldwright::describe(message);
    expect(message.code != "internal" && message.code != "out-of-memory", text);
    foldwright::fuzz::expect_refusal(message.code, text);
  } else {
    expect(std::holds_alternative<foldwright::CancelledEvent>(end), "a job tells how it ended");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::span bytes = std::as_bytes(std::span(data, size));
  if (!is_small(bytes)) return -1;  // no seed either: the readers have programs of their own
  foldwright::Job job({{kFileName, {bytes.begin(), bytes.end()}}},
                      {.parts = {.runs = 8}, .nets = {.compaction = size % kEvery == 0}});
  foldwright::Events events;
  for (int step = 0; step < kMostSteps && !job.finished(); ++step) events = job.step(kWorkOfStep);
  if (!job.finished()) events = job.cancel();
  expect(!events.empty(), "a job tells how it ended");
  expect_good_end(events.back());
  return 0;
}
