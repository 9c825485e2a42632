#include <gtest/gtest.h>

#include "drawn_shapes.h"
#include "folding.h"
#include "job_runs.h"
#include "meshes.h"

namespace foldwright::testing {
namespace {

TEST(JobFolding, FoldsEveryPiece) {
  const std::pair<Mesh, JobOptions> cases[] = {
      {cube(), {.parts = {.count = 1}}},
      {l_prism(), {.parts = {.count = 2, .runs = 20}}},
      {torus(10, 7), {.parts = {.count = 3, .runs = 40}}},
      {bumpy_sphere(200), {.parts = {.count = 4, .runs = 40}}},
      {dumbbell(), {.parts = {.count = 1}, .nets = {.folding = FoldingMode::kRequire}}},
      {two_sided_square(), {.parts = {.count = 1}}},
      {open_strip(3), {.parts = {.count = 1}}},
      {bumpy_sphere(120),
       {.parts = {.count = 2, .runs = 40}, .nets = {.solver = Solver::kGenetic}}}};
  for (const auto& [mesh, options] : cases) {
    SCOPED_TRACE(mesh.face_count());
    const Outcome outcome = run(mesh, options);
    expect_sound(outcome);
    EXPECT_FALSE(outcome.notices().contains("no-motion"));
    const JobResult& result = *outcome.result;
    const DualGraph graph = build_dual_graph(result.mesh);
    for (const Piece& piece : result.pieces) {
      EXPECT_EQ(fault_of_motion(piece.motion, piece.net), "");
      EXPECT_TRUE(colliding_times(result, graph, piece, 200).empty());
    }
  }
}

TEST(JobFolding, WouldBeCaughtWithAWrongMotion) {
  // What the test before rests on: half as far again, the faces run into each other.
  const JobResult result = *run(bumpy_sphere(120), {.parts = {.count = 2, .runs = 20}}).result;
  const DualGraph graph = build_dual_graph(result.mesh);
  Piece piece = result.pieces[0];
  for (double& angle : piece.motion.angles.back()) angle *= 1.5;
  EXPECT_FALSE(colliding_times(result, graph, piece, 200).empty());
  EXPECT_NE(fault_of_motion(piece.motion, piece.net), "");
}

TEST(JobFolding, LooksAtNoMotionWhenFoldingIsOff) {
  const Outcome outcome =
      run(crossing_strip(), {.parts = {.count = 1}, .nets = {.folding = FoldingMode::kOff}});
  expect_sound(outcome);
  EXPECT_EQ(outcome.notices(), std::multiset<std::string>{"unchecked-pieces"});
  EXPECT_EQ(describe(outcome.result->notices[0]), "unchecked-pieces what=off pieces=A");
  for (const Piece& piece : outcome.result->pieces) {
    EXPECT_EQ(piece.motion.kind, Folding::kUnchecked);
    EXPECT_TRUE(piece.motion.times.empty());
    EXPECT_TRUE(piece.motion.angles.empty());
  }
}

TEST(JobFolding, SaysWhenAModelMeetsItself) {
  const Outcome outcome =
      run(crossing_strip(), {.parts = {.count = 1}, .nets = {.folding = FoldingMode::kPrefer}});
  expect_sound(outcome);
  EXPECT_TRUE(outcome.notices().contains("meets-itself"));
  EXPECT_FALSE(outcome.notices().contains("no-motion"));
  ASSERT_EQ(outcome.result->pieces.size(), 1u);
  EXPECT_EQ(outcome.result->pieces[0].motion.kind, Folding::kNone);
  EXPECT_TRUE(outcome.result->pieces[0].motion.times.empty());
}

TEST(JobFolding, SplitsAModelThatMeetsItselfIfAMotionIsRequired) {
  const Outcome outcome = run(crossing_strip(), {.parts = {.count = 1, .runs = 20},
                                                 .nets = {.folding = FoldingMode::kRequire}});
  expect_sound(outcome);
  EXPECT_GT(outcome.result->pieces.size(), 1u);
  for (const Piece& piece : outcome.result->pieces) {
    EXPECT_EQ(piece.cause, Cause::kNoMotion);
    EXPECT_EQ(fault_of_motion(piece.motion, piece.net), "");
  }
}

TEST(JobFolding, FoldsTheShareOfAModelThatMeetsItselfThatDoesNot) {
  // In two parts, each free of itself, the strip folds.
  const Outcome outcome = run(crossing_strip(), {.parts = {.count = 2, .runs = 20}});
  expect_sound(outcome);
  EXPECT_FALSE(outcome.notices().contains("meets-itself"));
  for (const Piece& piece : outcome.result->pieces) {
    EXPECT_EQ(fault_of_motion(piece.motion, piece.net), "");
  }
}

/// A job of one part whose host says of all nets of the whole model that they do not fold.
Outcome run_without_motion(const Mesh& mesh, FoldingMode folding) {
  Job job({{"model.obj", to_bytes(obj_of(mesh))}},
          {.parts = {.count = 1, .runs = 20}, .nets = {.folding = folding}});
  const auto panels = static_cast<std::size_t>(build_dual_graph(mesh).panel_count());
  Outcome outcome;
  while (!job.finished()) {
    append(outcome, job.advance());
    while (const auto task = job.take_task()) {
      TaskRunner runner(*task);
      while (!runner.step(kSlice)) continue;
      TaskResult result = runner.result();
      if (task->panels.size() == panels) {
        if (auto* planned = std::get_if<PlanResult>(&result))
          planned->motion = {Folding::kNone, {}, {}};
        if (auto* searched = std::get_if<SearchResult>(&result)) {
          searched->folds_straight = false;
          searched->shortfall = 1;
        }
      }
      append(outcome, job.complete(task->id, std::move(result)));
    }
  }
  finish(outcome, job);
  return outcome;
}

TEST(JobFolding, KeepsANetWithoutAMotionUnlessOneIsRequired) {
  const Outcome kept = run_without_motion(icosahedron(), FoldingMode::kPrefer);
  expect_sound(kept);
  ASSERT_EQ(kept.result->pieces.size(), 1u);
  EXPECT_EQ(kept.result->pieces[0].motion.kind, Folding::kNone);
  EXPECT_EQ(kept.notices(), std::multiset<std::string>{"no-motion"});
  const Outcome split = run_without_motion(icosahedron(), FoldingMode::kRequire);
  expect_sound(split);
  EXPECT_EQ(split.result->pieces.size(), 2u);
  for (const Piece& piece : split.result->pieces) {
    EXPECT_EQ(piece.cause, Cause::kNoMotion);
    EXPECT_EQ(fault_of_motion(piece.motion, piece.net), "");
  }
  EXPECT_EQ(split.notices(), std::multiset<std::string>{"part-split"});
}

}  // namespace
}  // namespace foldwright::testing
