#include "read/model_files.h"

#include <gtest/gtest.h>

#include "job_runs.h"
#include "mesh/input_error.h"
#include "meshes.h"

namespace foldwright::testing {
namespace {

ModelFile file(const std::string& name, const std::string& contents) {
  return {name, to_bytes(contents)};
}

ModelFile model(const std::string& name) { return file(name, obj_of(cube())); }

const ModelFile kMaterials = file("cube.mtl", "newmtl wood\nmap_Kd wood.png\n");
const ModelFile kPicture = file("textures/wood.png", "\x89PNG and so on");

/// With what files are refused.
std::string refusal(const std::vector<ModelFile>& files) {
  try {
    find_model(files);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(FindModel, IsTheOneWithContentsOfAModel) {
  EXPECT_EQ(find_model(std::vector{kMaterials, kPicture, model("cube.obj")}), 2u);
  EXPECT_EQ(find_model(std::vector{file("notes.obj", "Dear Sir"), model("cube.txt")}), 1u)
      << "contents before endings";
}

TEST(FindModel, GoesByEndingsWhereContentsShowNothing) {
  const ModelFile headless = file("cube.OFF", "8 6 12\n0 0 0\n");
  EXPECT_EQ(find_model(std::vector{kMaterials, headless, kPicture}), 1u);
}

TEST(FindModel, TakesASingleFileForOne) {
  EXPECT_EQ(find_model(std::vector{kPicture}), 0u) << "the reader says what is wrong with it";
}

TEST(FindModel, RefusesSeveralModelsAndNamesTwo) {
  EXPECT_EQ(refusal({model("a.obj"), kMaterials, model("parts/b.obj")}),
            "several-models count=2 first=a.obj second=parts/b.obj");
  EXPECT_EQ(refusal({model("a.obj"), model("b.obj"), model("c.obj")}),
            "several-models count=3 first=a.obj second=b.obj");
}

TEST(FindModel, RefusesFilesWithoutAModel) {
  EXPECT_EQ(refusal({kMaterials, kPicture}), "no-model count=2");
  EXPECT_EQ(refusal({kPicture, file("cube.glb", "glTF and so on")}),
            "unknown-format what=file file=cube.glb format=glb");
}

TEST(ModelFiles, OfAJobMayBeSeveral) {
  const JobOptions options{.parts = {.count = 1, .runs = 10}};
  const Outcome alone = run_job(Job({model("cube.obj")}, options));
  const Outcome several = run_job(Job({kMaterials, model("cube.obj"), kPicture}, options));
  expect_sound(several);
  EXPECT_EQ(several.result->file, "cube.obj");
  EXPECT_EQ(several.all<ModelEvent>().at(0).file, "cube.obj");
  EXPECT_EQ(several.result->hash, alone.result->hash);
  EXPECT_EQ(alone.notices().count("files-ignored"), 0u);
  ASSERT_EQ(several.notices().count("files-ignored"), 1u);
  for (const Notice& notice : several.result->notices) {
    if (notice.code != "files-ignored") continue;
    const std::vector<std::string> names = {"cube.mtl", "textures/wood.png"};
    EXPECT_EQ(notice.parameters, (Parameters{{"files", names}}));
  }
}

TEST(ModelFiles, WithoutAModelAreRefused) {
  const Outcome outcome = run_job(Job({kMaterials, kPicture}, {}));
  EXPECT_EQ(outcome.all<ErrorEvent>().at(0).message.code, "no-model");
}

}  // namespace
}  // namespace foldwright::testing
