#include <gtest/gtest.h>

#include "data_files.h"
#include "folding.h"
#include "job_runs.h"
#include "mesh/carry_origins.h"
#include "mesh/input_error.h"
#include "mesh_faults.h"
#include "meshes.h"
#include "pipeline/job.h"
#include "read/read_model.h"
#include "shared_models.h"
#include "simplify/simplify.h"

namespace foldwright::testing {
namespace {

namespace fs = std::filesystem;

/// Whether a model can be read and mended; then its corners know where they come from, also once
/// it is simplified to a third.
bool check_origins(const fs::path& path) {
  SCOPED_TRACE(path.filename().string());
  const std::string text = bytes_of(path);
  try {
    const PolygonSoup soup = read_model(std::as_bytes(std::span(text)), path.filename().string());
    const RepairedModel model = repair(soup);
    EXPECT_EQ(origin_fault_of(soup, model), "");
    const Mesh simple = simplify(model.mesh, {.target_faces = model.mesh.face_count() / 3});
    const auto carried = carry_origins(model.mesh, model.origins, simple);
    EXPECT_EQ(origin_fault_of(soup, model, simple, carried), "");
    return true;
  } catch (const InputError&) {
    return false;
  }
}

TEST(Corpus, HostileFilesAreRefusedInOneSentenceOrMended) {
  const std::vector<fs::path> files = files_below("nasty");
  if (files.empty()) GTEST_SKIP() << kNoSharedModels;
  for (const fs::path& path : files) {
    SCOPED_TRACE(path.filename().string());
    try {
      const RepairedModel model = load(path);
      EXPECT_EQ(fault_of(model.mesh), "");
      EXPECT_EQ(bookkeeping_fault_of(model), "");
    } catch (const InputError& error) {
      const std::string sentence = error.what();
      EXPECT_NE(sentence, "");
      EXPECT_NE(error.code(), "");
      EXPECT_EQ(sentence.find('\n'), std::string::npos);
    }
  }
}

TEST(Corpus, GoodModelsAreReadAndMended) {
  int count = 0;
  for (const char* folder : {"models/academic", "models/lowpoly", "models/organic"}) {
    for (const fs::path& path : files_below(folder)) {
      if (path.extension() != ".obj" && path.extension() != ".off") continue;
      SCOPED_TRACE(path.filename().string());
      const RepairedModel model = load(path);
      EXPECT_EQ(fault_of(model.mesh), "");
      EXPECT_EQ(bookkeeping_fault_of(model), "");
      ++count;
    }
  }
  if (count == 0) GTEST_SKIP() << kNoSharedModels;
}

TEST(Corpus, ClosedManifoldsNeedNoRepair) {
  const std::vector<fs::path> files = files_below("models/organic");
  if (files.empty()) GTEST_SKIP() << kNoSharedModels;
  for (const fs::path& path : files) {
    SCOPED_TRACE(path.filename().string());
    const RepairedModel model = load(path);
    EXPECT_TRUE(model.repairs.empty());
    EXPECT_EQ(border_edge_count(model.mesh), 0);
    EXPECT_EQ(model.mesh.face_count(), model.source_face_count);
  }
}

TEST(Corpus, EveryPieceFoldsUp) {
  int count = 0;
  for (const fs::path& path : files_below("models/organic")) {
    const std::string name = path.filename().string();
    if (!name.ends_with("_300.obj")) continue;
    SCOPED_TRACE(name);
    const std::string text = bytes_of(path);
    Job job({{name, to_bytes(text)}}, {.parts = {.count = 8, .runs = 100}});
    Events events;
    while (!job.finished()) events = job.step(1000000);
    ASSERT_TRUE(std::holds_alternative<DoneEvent>(events.back()));
    const JobResult& result = *std::get<DoneEvent>(events.back()).result;
    EXPECT_EQ(result.pieces.size(), 8u);
    const DualGraph graph = build_dual_graph(result.mesh);
    for (const Piece& piece : result.pieces) {
      EXPECT_EQ(fault_of_motion(piece.motion, piece.net), "");
      // Looking at all pairs a thousand times is slow: at those of every third model.
      if (count % 3 != 0) continue;
      EXPECT_TRUE(colliding_times(result, graph, piece, 1000).empty());
    }
    ++count;
  }
  if (count == 0) GTEST_SKIP() << kNoSharedModels;
}

TEST(Corpus, CornersOfOwnModelsKnowWhereTheyComeFrom) {
  for (const fs::path& path : corpus_files()) EXPECT_TRUE(check_origins(path)) << path;
  int count = 0;
  for (const auto& [file, outcome] : reproductions()) count += check_origins(file);
  EXPECT_GT(count, 10);
}

TEST(Corpus, CornersOfSharedModelsKnowWhereTheyComeFrom) {
  int count = 0;
  for (const char* folder : {"cases", "nasty", "models"}) {
    for (const fs::path& path : files_below(folder)) count += check_origins(path);
  }
  if (count == 0) GTEST_SKIP() << kNoSharedModels;
}

TEST(Corpus, OwnModelsAreReadAndMended) {
  for (const fs::path& path : corpus_files()) {
    SCOPED_TRACE(path.filename().string());
    const RepairedModel model = load(path);
    EXPECT_EQ(fault_of(model.mesh), "");
    EXPECT_EQ(bookkeeping_fault_of(model), "");
  }
}

TEST(Corpus, OwnModelsBecomeNetsThatFold) {
  for (const fs::path& path : corpus_files()) {
    for (const int parts : {0, 3}) {
      SCOPED_TRACE(path.filename().string() + " in " + std::to_string(parts) + " parts");
      const Outcome outcome = run_file(bytes_of(path), path.filename().string(),
                                       {.parts = {.count = parts, .runs = 100}});
      expect_sound(outcome);
      ASSERT_TRUE(outcome.result);
      const DualGraph graph = build_dual_graph(outcome.result->mesh);
      for (const Piece& piece : outcome.result->pieces) {
        EXPECT_EQ(fault_of_motion(piece.motion, piece.net), "");
        EXPECT_TRUE(colliding_times(*outcome.result, graph, piece, 20).empty());
      }
    }
  }
}

}  // namespace
}  // namespace foldwright::testing
