#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "job_runs.h"
#include "meshes.h"
#include "pipeline/job.h"

namespace foldwright {
namespace {

JobOptions options_of_six_parts() {
  JobOptions options;
  options.parts.count = 6;
  options.parts.runs = 30;
  return options;
}

Job job_of_six_parts() {
  return Job({{"hills.obj", testing::to_bytes(testing::obj_of(testing::bumpy_sphere(300)))}},
             options_of_six_parts());
}

/// The draft of a job, if it has one.
std::shared_ptr<const JobResult> draft_of(const Job& job) {
  const Events events = job.draft();
  if (events.empty()) return nullptr;
  EXPECT_EQ(events.size(), 1u);
  return std::get<DraftEvent>(events.front()).result;
}

TEST(JobDraft, IsThereOnceEveryPartHasANet) {
  Job job = job_of_six_parts();
  std::vector<std::shared_ptr<const JobResult>> drafts;
  StageId stage = StageId::kRead;
  while (!job.finished()) {
    for (const Event& event : job.step(20000)) {
      if (const auto* told = std::get_if<StageEvent>(&event)) stage = told->stage;
    }
    const auto draft = draft_of(job);
    if (stage < StageId::kSearch) {
      EXPECT_EQ(draft, nullptr);
    }
    if (stage == StageId::kCompact) {
      EXPECT_NE(draft, nullptr);
    }
    if (draft) drafts.push_back(draft);
  }
  EXPECT_EQ(draft_of(job), nullptr);
  ASSERT_GT(drafts.size(), 1u);
  for (const auto& draft : drafts) {
    EXPECT_EQ(draft->pieces.size(), 6u);
    int faces = 0;
    for (const Piece& piece : draft->pieces) {
      EXPECT_TRUE(piece.check.valid());
      faces += static_cast<int>(piece.net.faces.size());
    }
    EXPECT_EQ(faces, draft->mesh.face_count());
    EXPECT_EQ(draft->sheets.placements.size(), draft->pieces.size());
  }
}

TEST(JobDraft, ChangesNothingOfWhatComes) {
  const auto undisturbed = testing::run_job(job_of_six_parts());
  Job job = job_of_six_parts();
  testing::Outcome outcome;
  while (!job.finished()) {
    testing::append(outcome, job.step(testing::kSlice));
    draft_of(job);
  }
  testing::finish(outcome, job);
  EXPECT_EQ(outcome.result->hash, undisturbed.result->hash);
}

TEST(JobDraft, IsWhatACancelledJobHandsOver) {
  Job job = job_of_six_parts();
  std::shared_ptr<const JobResult> draft;
  while (!draft) {
    ASSERT_FALSE(job.finished());
    job.step(20000);
    draft = draft_of(job);
  }
  const Events last = job.cancel();
  ASSERT_EQ(last.size(), 1u);
  EXPECT_EQ(std::get<CancelledEvent>(last.front()).best->hash, draft->hash);
}

}  // namespace
}  // namespace foldwright
