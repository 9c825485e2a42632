#include <gtest/gtest.h>

#include <set>

#include "job_runs.h"
#include "meshes.h"
#include "pipeline/job.h"

namespace foldwright {
namespace {

/// Runs a job with six parts until `wanted` nets are found, then cancels it.
CancelledEvent cancel_after(int wanted) {
  JobOptions options;
  options.parts.count = 6;
  options.parts.runs = 30;
  Job job({{"hills.obj", testing::to_bytes(testing::obj_of(testing::bumpy_sphere(300)))}}, options);
  int nets = 0;
  while (nets < wanted) {
    for (const Event& event : job.step(1000)) nets += std::holds_alternative<NetEvent>(event);
  }
  const Events last = job.cancel();
  EXPECT_TRUE(job.finished());
  EXPECT_TRUE(job.step(1000).empty());
  EXPECT_EQ(last.size(), 1u);
  return std::get<CancelledEvent>(last.back());
}

TEST(JobCancel, KeepsNothingBeforeTheFirstNet) { EXPECT_EQ(cancel_after(0).best, nullptr); }

TEST(JobCancel, KeepsTheNetsFoundSoFar) {
  for (const int wanted : {1, 3}) {
    const auto best = cancel_after(wanted).best;
    ASSERT_NE(best, nullptr);
    EXPECT_GE(static_cast<int>(best->pieces.size()), wanted);
    EXPECT_LT(best->pieces.size(), 6u);
    std::set<int> faces;
    for (const Piece& piece : best->pieces) {
      EXPECT_TRUE(piece.check.valid());
      for (const int face : piece.net.faces) {
        EXPECT_TRUE(faces.insert(face).second) << "face " << face << " is in two pieces";
        EXPECT_EQ(best->labels[face], piece.part);
      }
    }
    EXPECT_EQ(best->sheets.placements.size(), best->pieces.size());
  }
}

}  // namespace
}  // namespace foldwright
