// Whole jobs, since what is looked at is what they come to.
#include "pipeline/sheets/sheet_saver.h"

#include <gtest/gtest.h>

#include "craft_shapes.h"
#include "job_runs.h"

namespace foldwright::testing {
namespace {

/// Three cubes side by side, which are of this height in mm.
Outcome unfold(double side) {
  std::vector<Solid> cubes(3, craft_shapes()[0].solid);
  for (int i = 1; i < 3; ++i) {
    for (Vec3& p : cubes[i].positions) p.x() += 100 * i;
  }
  JobOptions options;
  options.paper.size = {Sizing::kHeight, side};
  return run_file(obj_of(together("", cubes)), "cubes.obj", options);
}

TEST(SheetSaver, TellsTheSizeThatNeedsASheetLess) {
  // As small as that the three nets go on one sheet.
  double side = 25;
  Outcome before = unfold(side);
  Outcome outcome = before;
  while (outcome.result && outcome.result->sheets.sheet_count == 1 && side < 80) {
    before = outcome;
    outcome = unfold(++side);
  }
  ASSERT_TRUE(outcome.result && before.result);
  ASSERT_EQ(outcome.result->sheets.sheet_count, 2);
  EXPECT_EQ(before.notices().count("smaller-saves-sheets"), 0u);
  ASSERT_EQ(outcome.notices().count("smaller-saves-sheets"), 1u) << side;
  for (const Notice& notice : outcome.result->notices) {
    if (notice.code != "smaller-saves-sheets") continue;
    const auto size = std::ranges::find(notice.parameters, "size_mm", &Parameter::name);
    ASSERT_NE(size, notice.parameters.end());
    const double told = std::get<double>(size->value);
    EXPECT_NEAR(told, side - 1, 1);
    EXPECT_EQ(unfold(told).result->sheets.sheet_count, 1);
  }
}

}  // namespace
}  // namespace foldwright::testing
