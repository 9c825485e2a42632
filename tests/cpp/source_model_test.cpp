#include "pipeline/model/source_model.h"

#include <gtest/gtest.h>

#include "job_runs.h"
#include "mesh/input_error.h"

namespace foldwright::testing {
namespace {

std::vector<ModelFile> files_of(const std::string& text) { return {{"a.obj", to_bytes(text)}}; }

TEST(SourceModel, KnowsFileAndNotices) {
  std::vector<ModelFile> files = files_of(obj_of(tetrahedron()));
  files.push_back({"readme.txt", to_bytes("hello")});
  const SourceModel model = read_source_model(files, {});
  EXPECT_EQ(model.file, "a.obj");
  EXPECT_EQ(model.mesh.face_count(), 4);
  EXPECT_EQ(model.origins.size(), 4u);
  ASSERT_EQ(model.notices.size(), 1u);
  EXPECT_EQ(describe(model.notices[0]), "files-ignored files=readme.txt");
}

TEST(ModelMemory, ReadsTheSameFilesOnce) {
  ModelMemory memory;
  const auto files = files_of(obj_of(tetrahedron()));
  const auto model = memory.read(files, {});
  EXPECT_EQ(memory.read(files, {}), model);
  EXPECT_NE(memory.read(files, {.up = Up::kZ}), model);
  EXPECT_NE(memory.read(files, {.up = Up::kZ}),
            memory.read(files, {.up = Up::kZ, .fill_holes = 5}));
  EXPECT_NE(memory.read(files, {}), memory.read(files, {.drop_inner = true}));
  EXPECT_NE(memory.read(files, {}), memory.read(files, {.unite = true}));
  EXPECT_NE(memory.read(files, {}), memory.read(files, {.off = RepairSteps(1)}));
  EXPECT_NE(memory.read(files_of(obj_of(cube())), {.up = Up::kZ})->mesh.face_count(), 4);
}

TEST(ModelMemory, SimplifiesTheWholeModelThatItHas) {
  ModelMemory memory;
  const auto files = files_of(obj_of(bumpy_sphere(600)));
  const auto whole = memory.read(files, {});
  const auto simple = memory.read(files, {.faces = 100});
  EXPECT_EQ(memory.read(files, {.faces = 100}), simple);
  EXPECT_EQ(memory.read(files, {}), whole);
  EXPECT_EQ(memory.read(files, {.faces = 5000}), whole);
  for (const int faces : {100, 200}) {
    const auto again = memory.read(files, {.faces = faces});
    const SourceModel alone = read_source_model(files, {.faces = faces});
    EXPECT_LE(again->mesh.face_count(), faces);
    EXPECT_EQ(again->mesh.faces, alone.mesh.faces);
    EXPECT_EQ(again->mesh.positions, alone.mesh.positions);
    EXPECT_EQ(again->face_standins, alone.face_standins);
    EXPECT_EQ(again->source_faces, alone.source_faces);
    EXPECT_EQ(again->simplified_deviation, alone.simplified_deviation);
    EXPECT_EQ(again->file_face_count, alone.file_face_count);
  }
}

TEST(ModelMemory, KeepsNothingOfAFileThatGivesNoModel) {
  ModelMemory memory;
  const auto files = files_of(obj_of(tetrahedron()));
  memory.read(files, {});
  EXPECT_THROW(memory.read(files_of("v 0 0 0\n"), {}), InputError);
  EXPECT_EQ(memory.read(files, {})->mesh.face_count(), 4);
}

TEST(Job, ComesToTheSameWithAndWithoutAMemory) {
  const auto memory = std::make_shared<JobMemory>();
  const JobOptions options = {.parts = {.count = 2, .runs = 10}};
  for (const Mesh& mesh : {cube(), bumpy_sphere(100), cube()}) {
    const auto files = files_of(obj_of(mesh));
    const Outcome alone = run_job(Job(files, options));
    for (int round = 0; round < 2; ++round) {
      const Outcome again = run_job(Job(files, options, {}, memory));
      EXPECT_EQ(again.result->hash, alone.result->hash);
      EXPECT_EQ(again.notices(), alone.notices());
      EXPECT_EQ(again.result->printed_ids, alone.result->printed_ids);
    }
  }
}

}  // namespace
}  // namespace foldwright::testing
