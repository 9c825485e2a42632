// How many parts a job makes, and that each of them gets a net, whatever its shape.

#include <gtest/gtest.h>

#include "drawn_shapes.h"
#include "job_runs.h"
#include "meshes.h"
#include "shared_models.h"

namespace foldwright::testing {
namespace {

TEST(JobParts, AreAsManyAsAskedForFromOneToAllFaces) {
  const Mesh mesh = random_hull(1, 14);
  ASSERT_EQ(build_dual_graph(mesh).panel_count(), mesh.face_count());
  for (int parts = 1; parts <= mesh.face_count(); ++parts) {
    SCOPED_TRACE(parts);
    const Outcome outcome =
        run(mesh, {.parts = {.count = parts, .runs = 20}, .nets = {.compaction = false}});
    expect_sound(outcome);
    EXPECT_EQ(outcome.result->parts, parts);
    EXPECT_EQ(static_cast<int>(outcome.result->pieces.size()), parts);
    std::multiset<std::string> notices = outcome.notices();
    notices.erase("smaller-saves-sheets");  // may be told of any number of sheets
    EXPECT_TRUE(notices.empty());
  }
  const Outcome more = run(
      mesh, {.parts = {.count = mesh.face_count() + 1, .runs = 20}, .nets = {.compaction = false}});
  expect_sound(more);
  EXPECT_EQ(more.result->parts, mesh.face_count());
  const auto notices = more.all<Notice>();
  ASSERT_EQ(notices.size(), 1u);
  EXPECT_EQ(describe(notices[0]), "parts-lowered panels=24");
}

TEST(JobParts, AreAsManyAsAskedForOnProxies) {
  const Mesh mesh = bumpy_sphere(300);
  const int faces = mesh.face_count();
  for (const int parts : {1, 2, 20, faces / 2, faces - 1, faces}) {
    SCOPED_TRACE(parts);
    const Outcome outcome = run(
        mesh, {.parts = {.count = parts, .runs = 20, .proxy = 100}, .nets = {.compaction = false}});
    expect_sound(outcome);
    EXPECT_EQ(outcome.result->parts, parts);
  }
}

TEST(JobParts, GetANetEvenIfTheyAreClosedOrHaveHandles) {
  for (const Mesh& mesh : {torus(10, 7), torus(24, 15), pretzel(), dumbbell(), star()}) {
    SCOPED_TRACE(mesh.face_count());
    for (const FoldingMode folding : {FoldingMode::kOff, FoldingMode::kPrefer}) {
      const Outcome outcome =
          run(mesh, {.parts = {.count = 1}, .nets = {.folding = folding, .compaction = false}});
      expect_sound(outcome);
      EXPECT_EQ(outcome.result->pieces.size(), 1u);
    }
  }
}

TEST(JobParts, GetANetEvenOfASkullWithHandles) {
  if (files_below("models").empty()) GTEST_SKIP() << kNoSharedModels;
  for (const char* name : {"skull_300.obj", "skull_574.obj"}) {
    SCOPED_TRACE(name);
    const auto path = shared_folder() / "models/organic" / name;
    const Outcome outcome =
        run_file(bytes_of(path), name, {.parts = {.count = 1}, .nets = {.compaction = false}});
    expect_sound(outcome);
    EXPECT_EQ(outcome.result->pieces.size(), 1u);
  }
}

/// A block with a square tunnel through it, whose walls are too long to lie within its openings.
std::string block_with_tunnel() {
  std::string text;
  for (const char* z : {"0", "4"}) {
    for (const char* xy :
         {"-2 -2", "2 -2", "2 2", "-2 2", "-.5 -.5", ".5 -.5", ".5 .5", "-.5 .5"}) {
      text += std::string("v ") + xy + " " + z + "\n";
    }
  }
  const auto quad = [&](int a, int b, int c, int d) {
    text += "f";
    for (const int v : {a, b, c, d}) text += " " + std::to_string(v + 1);
    text += "\n";
  };
  for (int i = 0; i < 4; ++i) {
    const int next = (i + 1) % 4;
    quad(next, i, i + 4, next + 4);            // below
    quad(i + 8, next + 8, next + 12, i + 12);  // above
    quad(i, next, next + 8, i + 8);            // outside
    quad(next + 4, i + 4, i + 12, next + 12);  // in the tunnel
  }
  return text;
}

TEST(JobParts, OfSimpleShapesAreOneWhereNobodyChoosesANumber) {
  for (const Mesh& mesh : {l_prism(), dumbbell(), star(), accordion({1, 2, 1})}) {
    SCOPED_TRACE(mesh.face_count());
    const Outcome outcome = run(mesh, {.nets = {.compaction = false}});
    expect_sound(outcome);
    EXPECT_EQ(outcome.result->parts, 1);
    EXPECT_EQ(outcome.result->pieces.size(), 1u);
  }
}

TEST(JobParts, AreThePiecesThatComeOutWhereNobodyChoosesANumber) {
  const std::string text = block_with_tunnel();
  const Outcome whole =
      run_file(text, "block.obj", {.parts = {.count = 1}, .nets = {.compaction = false}});
  expect_sound(whole);
  const std::size_t pieces = whole.result->pieces.size();
  EXPECT_GT(pieces, 1u);
  EXPECT_TRUE(whole.notices().contains("part-split"));
  const Outcome outcome = run_file(text, "block.obj", {.nets = {.compaction = false}});
  expect_sound(outcome);
  EXPECT_EQ(outcome.result->pieces.size(), pieces);
  EXPECT_EQ(outcome.result->parts, static_cast<int>(pieces));
  EXPECT_FALSE(outcome.notices().contains("part-split"));
}

TEST(JobParts, AreAsManyAsTheSheetsWantWhereNobodyChoosesANumber) {
  JobOptions options{.nets = {.compaction = false}};
  options.paper.size = {Sizing::kHeight, 180};
  const Outcome outcome = run(l_prism(), options);
  expect_sound(outcome);
  EXPECT_GT(outcome.result->parts, 1);
}

}  // namespace
}  // namespace foldwright::testing
