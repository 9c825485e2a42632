// What once went wrong: every file of tests/repro, and models too large for a file.
#include <gtest/gtest.h>

#include "data_files.h"
#include "folding.h"
#include "job_runs.h"
#include "shared_models.h"

namespace foldwright::testing {
namespace {

/// Runs a model and asks of its nets what is asked of all: every face once, no overlaps, a motion
/// that leads from the sheet to the model.
void expect_outcome(const Reproduction& reproduction) {
  const Outcome outcome = run_file(bytes_of(reproduction.file),
                                   reproduction.file.filename().string(), {.parts = {.runs = 50}});
  if (reproduction.outcome != "nets") {
    ASSERT_EQ(outcome.all<ErrorEvent>().size(), 1u);
    EXPECT_EQ(outcome.all<ErrorEvent>()[0].message.code, reproduction.outcome);
    return;
  }
  expect_sound(outcome);
  if (!outcome.result) return;
  for (const Piece& piece : outcome.result->pieces) {
    EXPECT_EQ(fault_of_motion(piece.motion, piece.net), "");
  }
}

TEST(Repro, EveryFileComesToWhatTheManifestSays) {
  for (const Reproduction& reproduction : reproductions()) {
    SCOPED_TRACE(reproduction.file.filename().string());
    expect_outcome(reproduction);
  }
}

TEST(Repro, AThousandBodiesAreLaidOut) {
  // Their sheets once wanted more memory than there was.
  std::string text;
  for (int i = 0; i < 1000; ++i) {
    const std::string x = std::to_string(4 * (i % 40)) + " ";
    const std::string y = std::to_string(4 * (i / 40));
    const std::string far_x = std::to_string(4 * (i % 40) + 2) + " ";
    text += "v " + x + y + " 0\nv " + far_x + y + " 0\nv " + x + y + ".9 2\nv " + x + y + " 2\n" +
            "f -4 -3 -2\nf -3 -4 -1\nf -2 -3 -1\nf -4 -2 -1\n";
  }
  const Outcome outcome = run_file(text, "many.obj", {.parts = {.runs = 10}});
  expect_sound(outcome);
  EXPECT_EQ(outcome.result->pieces.size(), 1000u);
}

}  // namespace
}  // namespace foldwright::testing
