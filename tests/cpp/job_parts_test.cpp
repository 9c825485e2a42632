// How many parts a job makes, and that each of them gets a net, whatever its shape.

#include <gtest/gtest.h>

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
    const Outcome outcome = run(mesh, {.parts = parts, .runs = 20});
    expect_sound(outcome);
    EXPECT_EQ(outcome.result->parts, parts);
    EXPECT_EQ(static_cast<int>(outcome.result->pieces.size()), parts);
    EXPECT_TRUE(outcome.notices().empty());
  }
  const Outcome more = run(mesh, {.parts = mesh.face_count() + 1, .runs = 20});
  expect_sound(more);
  EXPECT_EQ(more.result->parts, mesh.face_count());
  const auto notices = more.all<Notice>();
  ASSERT_EQ(notices.size(), 1u);
  EXPECT_EQ(notices[0].text, "the model has only 24 flat panels, so it cannot have more parts");
}

TEST(JobParts, AreAsManyAsAskedForOnProxies) {
  const Mesh mesh = bumpy_sphere(300);
  const int faces = mesh.face_count();
  for (const int parts : {1, 2, 20, faces / 2, faces - 1, faces}) {
    SCOPED_TRACE(parts);
    const Outcome outcome = run(mesh, {.parts = parts, .runs = 20, .proxy = 100});
    expect_sound(outcome);
    EXPECT_EQ(outcome.result->parts, parts);
  }
}

TEST(JobParts, GetANetEvenIfTheyAreClosedOrHaveHandles) {
  for (const Mesh& mesh : {torus(10, 7), torus(24, 15), pretzel(), dumbbell(), star()}) {
    SCOPED_TRACE(mesh.face_count());
    for (const FoldingMode folding : {FoldingMode::kOff, FoldingMode::kPrefer}) {
      const Outcome outcome = run(mesh, {.parts = 1, .folding = folding});
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
    const Outcome outcome = run_file(bytes_of(path), name, {.parts = 1});
    expect_sound(outcome);
    EXPECT_EQ(outcome.result->pieces.size(), 1u);
  }
}

}  // namespace
}  // namespace foldwright::testing
