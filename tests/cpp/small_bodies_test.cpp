#include "pipeline/sheets/small_bodies.h"

#include <gtest/gtest.h>

#include "craft_shapes.h"
#include "job_runs.h"

namespace foldwright::testing {
namespace {

/// A cube of 60 mm and a dozen studs of 3 mm beside it.
std::string cube_with_studs() {
  std::vector<Solid> solids(13, craft_shapes()[0].solid);
  for (int i = 1; i < 13; ++i) {
    for (Vec3& p : solids[i].positions) p = 0.05 * p + Vec3(10 * i, 0, 70);
  }
  return obj_of(together("", solids));
}

Outcome run_at(double scale, double min_piece) {
  JobOptions options;
  options.paper.size = {Sizing::kScale, scale, Unit::kMillimetre};
  options.paper.min_piece = min_piece;
  return run_file(cube_with_studs(), "studs.obj", options);
}

TEST(SmallBodies, AreLeftOutAndTold) {
  const Outcome outcome = run_at(1, 4);
  ASSERT_TRUE(outcome.result);
  ASSERT_EQ(outcome.result->pieces.size(), 1u);
  EXPECT_EQ(outcome.result->pieces[0].name, "A");
  const auto notices = outcome.result->notices;
  const auto told = std::ranges::find(
      notices, "small-bodies", [](const Notice& notice) { return std::string(notice.code); });
  ASSERT_NE(told, notices.end());
  EXPECT_EQ(describe(*told), "small-bodies count=12 faces=144 limit_mm=4");
}

TEST(SmallBodies, CountByTheirFinishedSize) {
  EXPECT_EQ(run_at(0.5, 2).result->pieces.size(), 1u);
  const Outcome outcome = run_at(1, 2);
  expect_sound(outcome);
  EXPECT_EQ(outcome.result->pieces.size(), 13u);
  EXPECT_FALSE(outcome.notices().contains("small-bodies"));
}

TEST(SmallBodies, ArePrintedLaterWithoutANewSearch) {
  const Outcome before = run_at(1, 4);
  ASSERT_TRUE(before.result);
  ASSERT_EQ(before.result->nets.size(), 13u);
  JobStart start;
  start.labels = before.result->labels;
  start.nets = before.result->nets;
  JobOptions options;
  options.paper.size = {Sizing::kScale, 1, Unit::kMillimetre};
  const Outcome after =
      run_job(Job({{"studs.obj", to_bytes(cube_with_studs())}}, options, std::move(start)));
  expect_sound(after);
  EXPECT_EQ(after.result->pieces.size(), 13u);
  EXPECT_EQ(after.result->moves, 0);
}

TEST(SmallBodies, NeverIncludeTheLargest) {
  const Outcome outcome = run_at(1, 1000);
  ASSERT_TRUE(outcome.result);
  EXPECT_EQ(outcome.result->pieces.size(), 1u);
}

TEST(SmallBodies, ArePrintedUnlessAskedFor) {
  EXPECT_EQ(run_at(1, 0).result->pieces.size(), 13u);
  EXPECT_EQ(run_at(1, -1).result, nullptr);
}

}  // namespace
}  // namespace foldwright::testing
