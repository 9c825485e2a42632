#include <gtest/gtest.h>

#include "folding.h"
#include "job_runs.h"
#include "meshes.h"

namespace foldwright::testing {
namespace {

JobOptions at_height(double mm, int parts, bool compaction) {
  JobOptions options;
  options.parts.count = parts;
  options.parts.runs = 60;
  options.paper.size = {Sizing::kHeight, mm};
  options.nets.compaction = compaction;
  return options;
}

TEST(JobCompaction, MakesRoomForFlaps) {
  const Mesh mesh = bumpy_sphere(300);
  const Outcome before = run(mesh, at_height(80, 3, false));
  const Outcome after = run(mesh, at_height(80, 3, true));
  expect_sound(before);
  expect_sound(after);
  EXPECT_EQ(after.result->pieces.size(), before.result->pieces.size());
  EXPECT_LT(after.result->missed_flaps.size(), before.result->missed_flaps.size());
  EXPECT_LT(after.result->flap_counts.missing_length, before.result->flap_counts.missing_length);
  const DualGraph graph = build_dual_graph(after.result->mesh);
  for (const Piece& piece : after.result->pieces) {
    EXPECT_EQ(piece.motion.kind, Folding::kLine);
    EXPECT_EQ(fault_of_motion(piece.motion, piece.net), "");
    EXPECT_TRUE(colliding_times(*after.result, graph, piece, 200).empty());
  }
}

TEST(JobCompaction, GivesTheSameResultInAnySlices) {
  const Mesh mesh = bumpy_sphere(120);
  const JobOptions options = at_height(80, 2, true);
  EXPECT_EQ(run(mesh, options, 500).result->hash, run(mesh, options, 1 << 30).result->hash);
}

TEST(JobCompaction, BringsPiecesOntoTheSheet) {
  // What sticks out costs, so that fewer pieces are cut again.
  const Mesh mesh = bumpy_sphere(200);
  const auto pieces = [&](bool compaction) {
    const Outcome outcome = run(mesh, at_height(190, 2, compaction));
    expect_sound(outcome);
    return outcome.result->pieces.size();
  };
  EXPECT_LE(pieces(true), pieces(false));
}

TEST(JobCompaction, WorksWithoutFlapsAndWithoutFolding) {
  JobOptions options = at_height(100, 2, true);
  options.paper.flaps.side = FlapSide::kNone;
  expect_sound(run(bumpy_sphere(120), options));
  options.nets.folding = FoldingMode::kOff;
  const Outcome outcome = run(bumpy_sphere(120), options);
  expect_sound(outcome);
  for (const Piece& piece : outcome.result->pieces) {
    EXPECT_EQ(piece.motion.kind, Folding::kUnchecked);
  }
}

}  // namespace
}  // namespace foldwright::testing
