#include "pipeline/job.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <sstream>

#include "drawn_shapes.h"
#include "job_runs.h"
#include "meshes.h"
#include "model_text.h"
#include "pipeline/wire.h"
#include "repair/repair.h"
#include "shared_models.h"

namespace foldwright::testing {
namespace {

/// A host that sends tasks over the wire, and takes results in the opposite order.
Outcome run_elsewhere(const Mesh& mesh, const JobOptions& options) {
  Job job({{"model.obj", to_bytes(obj_of(mesh))}}, options);
  Outcome outcome;
  while (!job.finished()) {
    append(outcome, job.advance());
    std::vector<std::unique_ptr<TaskRunner>> runners;
    while (const auto task = job.take_task()) {
      const auto surface = decode_surface(encode(*task->surface));
      runners.push_back(std::make_unique<TaskRunner>(decode_task(encode(*task), surface)));
    }
    for (auto runner = runners.rbegin(); runner != runners.rend(); ++runner) {
      const int id = (*runner)->task().id;
      while (!(*runner)->step(1000)) {
        append(outcome, job.report(id, decode_status(encode((*runner)->status(true)))));
      }
      append(outcome, job.complete(id, decode_result(encode((*runner)->result()))));
    }
  }
  finish(outcome, job);
  return outcome;
}

/// Two bodies as one mesh, the second moved clear of the first.
Mesh beside(const Mesh& first, const Mesh& second) {
  std::vector<Vec3> positions = first.positions;
  std::vector<std::array<int, 3>> faces = first.faces;
  const int offset = first.vertex_count();
  for (const Vec3& p : second.positions) positions.push_back(p + Vec3(9, 0, 0));
  for (const auto& [a, b, c] : second.faces) faces.push_back({a + offset, b + offset, c + offset});
  return make_mesh(std::move(positions), std::move(faces));
}

TEST(Job, MakesNetsOfSmallMeshes) {
  for (const Mesh& mesh : {cube(), tetrahedron(), icosahedron(), star(), torus(10, 7), l_prism(),
                           open_strip(4), two_sided_square(), accordion({1, 2, 1}), dumbbell()}) {
    SCOPED_TRACE(mesh.face_count());
    // A sheet given from both sides is one skin after repair.
    const int panels = build_dual_graph(repair(soup_of(mesh)).mesh).panel_count();
    for (const int parts : {0, 1, 2, 5}) {
      SCOPED_TRACE(parts);
      // Compaction takes its time whatever the mesh: once for each is enough.
      const Outcome outcome =
          run(mesh, {.parts = {.count = parts, .runs = 60}, .nets = {.compaction = parts == 2}});
      expect_sound(outcome);
      EXPECT_TRUE(parts == 0 || outcome.result->parts == std::min(parts, panels));
      EXPECT_EQ(static_cast<int>(outcome.result->pieces.size()), outcome.result->parts);
    }
  }
}

TEST(Job, MakesNetsWithEverySegmenterAndSolver) {
  for (const Mesh& mesh : {star(), random_hull(1, 60)}) {
    for (const Segmenter segmenter : {Segmenter::kShape, Segmenter::kFoldability}) {
      for (const Solver solver : {Solver::kTree, Solver::kGenetic}) {
        const JobOptions options = {.parts = {.count = 4, .segmenter = segmenter, .runs = 40},
                                    .nets = {.solver = solver, .compaction = false}};
        const Outcome outcome = run(mesh, options);
        expect_sound(outcome);
        EXPECT_EQ(outcome.result->parts, 4);
      }
    }
  }
}

TEST(Job, MakesANetOfAMoebiusStrip) {
  std::string text;
  const PolygonSoup strip = mobius_strip(9);
  std::ostringstream out;
  for (const Vec3& p : strip.positions) out << "v " << p.transpose() << '\n';
  for (int face = 0; face < strip.face_count(); ++face) {
    out << 'f';
    for (const int corner : corners_of(strip, face)) out << ' ' << corner + 1;
    out << '\n';
  }
  const Outcome outcome = run_file(out.str(), "strip.obj", {.parts = {.count = 1}});
  expect_sound(outcome);
  EXPECT_FALSE(outcome.result->repairs.empty());
  std::vector<std::string> told;
  for (const Notice& notice : outcome.all<Notice>()) told.push_back(describe(notice));
  for (const Repair& repair : outcome.result->repairs) {
    const std::string message = describe(message_of(repair));
    EXPECT_EQ(std::ranges::count(told, message), 1) << message;
  }
  EXPECT_EQ(outcome.result->segmentation, std::vector<int>(9, 0));
}

TEST(Job, MakesNetsOfSharedModels) {
  const std::pair<const char*, int> cases[] = {{"academic/bunny-348.obj", 8},
                                               {"academic/bumpy-528.obj", 1},
                                               {"organic/spot_300.obj", 8},
                                               {"organic/hand_574.obj", 4}};
  if (files_below("models").empty()) GTEST_SKIP() << kNoSharedModels;
  for (const auto& [name, parts] : cases) {
    SCOPED_TRACE(name);
    const auto path = shared_folder() / "models" / name;
    const Outcome outcome =
        run_file(bytes_of(path), path.filename().string(),
                 {.parts = {.count = parts, .runs = 100}, .nets = {.compaction = false}});
    expect_sound(outcome);
    EXPECT_EQ(outcome.result->parts, parts);
  }
}

TEST(Job, MakesNetsOfSharedLowPolyModels) {
  int count = 0;
  for (const auto& path : files_below("models/lowpoly")) {
    const std::string name = path.filename().string();
    // Every eighth, to keep it short: many are alike.
    if (path.extension() != ".obj" || count++ % 8 != 0) continue;
    SCOPED_TRACE(path.string());
    expect_sound(
        run_file(bytes_of(path), name, {.parts = {.runs = 20}, .nets = {.compaction = false}}));
  }
  if (count == 0) GTEST_SKIP() << kNoSharedModels;
}

TEST(Job, TellsProgressThatNeverFalls) {
  for (const JobOptions& options :
       {JobOptions{.parts = {.count = 3, .runs = 30}}, JobOptions{.parts = {.count = 1}}}) {
    const Outcome outcome = run(torus(10, 7), options, 500);
    double before = 0;
    int stage = 0;
    for (const StageEvent& event : outcome.all<StageEvent>()) {
      EXPECT_GE(event.progress, before);
      EXPECT_LE(event.progress, 1);
      EXPECT_GE(static_cast<int>(event.stage), stage);
      before = event.progress;
      stage = static_cast<int>(event.stage);
    }
    EXPECT_NEAR(before, 1, 1e-12);
    EXPECT_EQ(stage, static_cast<int>(StageId::kPaper));
  }
}

TEST(Job, TellsWhatItFinds) {
  const Outcome outcome = run(dumbbell(), {.parts = {.count = 3, .runs = 30}}, 2000);
  expect_sound(outcome);
  ASSERT_EQ(outcome.all<ModelEvent>().size(), 1u);
  EXPECT_EQ(outcome.all<ModelEvent>()[0].surface->mesh.face_count(), 336);
  int runs = 0;
  bool pictured = false;
  for (const LearnedEvent& event : outcome.all<LearnedEvent>()) {
    EXPECT_GE(event.runs, runs);
    EXPECT_EQ(event.of, 30);
    runs = event.runs;
    pictured = pictured || event.matrix;
  }
  EXPECT_EQ(runs, 30);
  EXPECT_TRUE(pictured);
  EXPECT_EQ(outcome.all<SegmentedEvent>().back().labels, outcome.result->labels);
  EXPECT_EQ(outcome.all<NetEvent>().size(), outcome.result->pieces.size());
  std::map<int, double> best;
  for (const GenerationEvent& event : outcome.all<GenerationEvent>()) {
    const auto [known, is_new] = best.try_emplace(event.part, event.best);
    EXPECT_GE(event.best, known->second) << "the fitness of part " << event.part << " fell";
    known->second = event.best;
  }
  for (const auto& [part, fitness] : best) EXPECT_EQ(fitness, 0) << "part " << part;
}

TEST(Job, GivesTheSameWhoeverRunsTheTasksInWhateverSlices) {
  const std::pair<Mesh, JobOptions> cases[] = {
      {torus(10, 7), {.parts = {.count = 4, .runs = 120}}},
      {bumpy_sphere(300), {.parts = {.count = 1}, .nets = {.compaction = false}}},
      {saddle(8, 7), {.parts = {.count = 1, .runs = 20}, .nets = {.compaction = false}}},
      {star(),
       {.parts = {.count = 2, .runs = 20},
        .nets = {.solver = Solver::kGenetic, .compaction = false}}}};
  for (const auto& [mesh, options] : cases) {
    SCOPED_TRACE(mesh.face_count());
    const std::string hash = run(mesh, options).result->hash;
    EXPECT_EQ(run(mesh, options).result->hash, hash);
    for (const std::int64_t slice :
         {std::int64_t{1}, std::int64_t{333}, std::int64_t{1000000000}}) {
      EXPECT_EQ(run(mesh, options, slice).result->hash, hash) << "slices of " << slice;
    }
    const Outcome elsewhere = run_elsewhere(mesh, options);
    ASSERT_NE(elsewhere.result, nullptr);
    EXPECT_EQ(elsewhere.result->hash, hash);
  }
}

TEST(Job, DependsOnTheSeed) {
  const auto hash = [](std::uint32_t seed) {
    return run(torus(10, 7),
               {.parts = {.count = 4, .runs = 20}, .nets = {.compaction = false}, .seed = seed})
        .result->hash;
  };
  EXPECT_NE(hash(1), hash(2));
}

TEST(Job, EndsWithOneErrorWhenTheInputIsBad) {
  struct Case {
    std::string text, name;
    JobOptions options;
    std::string code;
  };
  JobOptions wide_margin;
  wide_margin.paper.sheet.margin = 200;
  const std::string good = obj_of(cube());
  for (const Case& c : {Case{"no model at all", "model.obj", {}, "no-faces"},
                        Case{"", "model.stl", {}, "empty-file"},
                        Case{"no model at all", "model.xyz", {}, "unknown-format"},
                        Case{"v 0 0 0\nf 1 2 3\n", "model.obj", {}, "bad-index"},
                        Case{good, "model.obj", {.parts = {.runs = 0}}, "bad-option"},
                        Case{good, "model.obj", wide_margin, "bad-option"}}) {
    SCOPED_TRACE(c.text.substr(0, 20) + " " + c.name);
    const Outcome outcome = run_file(c.text, c.name, c.options);
    EXPECT_EQ(outcome.result, nullptr);
    const auto errors = outcome.all<ErrorEvent>();
    ASSERT_EQ(errors.size(), 1u);
    EXPECT_EQ(errors[0].message.code, c.code);
  }
}

TEST(Job, GivesEveryBodyItsOwnParts) {
  const Mesh two = beside(cube(), star());
  const Outcome one = run(two, {.parts = {.count = 1, .runs = 20}, .nets = {.compaction = false}});
  expect_sound(one);
  EXPECT_EQ(one.result->parts, 2);
  EXPECT_EQ(one.notices(), std::multiset<std::string>{"parts-raised"});
  const Outcome five = run(two, {.parts = {.count = 5, .runs = 20}, .nets = {.compaction = false}});
  expect_sound(five);
  EXPECT_EQ(five.result->parts, 5);
  EXPECT_TRUE(five.notices().empty());
  for (const Piece& piece : five.result->pieces) {
    const auto of_cube = std::ranges::count_if(piece.net.faces, [](int f) { return f < 12; });
    EXPECT_TRUE(of_cube == 0 || of_cube == std::ssize(piece.net.faces));
  }
  expect_sound(run(two, {.parts = {.runs = 20}, .nets = {.compaction = false}}));
}

TEST(Job, MakesNoMorePartsThanPanels) {
  const Outcome outcome = run(cube(), {.parts = {.count = 100, .runs = 10}});
  expect_sound(outcome);
  EXPECT_EQ(outcome.result->pieces.size(), 6u);
  EXPECT_EQ(outcome.notices(), std::multiset<std::string>{"parts-lowered"});
}

TEST(Job, SplitsABodyThatHasNoNet) {
  // Nothing was learned about it, since a single part was asked for.
  const Outcome outcome = run(saddle(8, 7), {.parts = {.count = 1, .runs = 20}});
  expect_sound(outcome);
  EXPECT_EQ(outcome.result->parts, 1);
  EXPECT_EQ(outcome.result->pieces.size(), 2u);
  for (const Piece& piece : outcome.result->pieces) EXPECT_EQ(piece.cause, Cause::kNoNet);
  EXPECT_EQ(outcome.notices(), std::multiset<std::string>{"part-split"});
  EXPECT_EQ(outcome.result->segmentation, std::vector<int>(8, 0));
}

TEST(Job, SimplifiesAndStillLabelsEverySourceFace) {
  const Mesh mesh = bumpy_sphere(800);
  const Outcome outcome = run(
      mesh,
      {.model = {.faces = 200}, .parts = {.count = 4, .runs = 30}, .nets = {.compaction = false}});
  expect_sound(outcome);
  EXPECT_LE(outcome.result->mesh.face_count(), 200);
  ASSERT_EQ(outcome.result->segmentation.size(), mesh.faces.size());
  const std::set<int> parts(outcome.result->segmentation.begin(),
                            outcome.result->segmentation.end());
  EXPECT_EQ(parts, (std::set<int>{0, 1, 2, 3}));
}

TEST(Job, SaysWhenItCannotSimplifyAsFarAsAsked) {
  const Outcome outcome = run(two_sided_square(), {.model = {.faces = 4}});
  expect_sound(outcome);
  const Outcome torus_outcome = run(torus(12, 9), {.model = {.faces = 4}, .parts = {.count = 1}});
  expect_sound(torus_outcome);
  EXPECT_GT(torus_outcome.result->mesh.face_count(), 4);
  EXPECT_EQ(torus_outcome.notices(), std::multiset<std::string>{"faces-above-wish"});
}

TEST(Job, LearnsOnAProxyAndKeepsAllFaces) {
  const Mesh mesh = bumpy_sphere(800);
  for (const int proxy : {0, 100, 799, 800}) {
    SCOPED_TRACE(proxy);
    const Outcome outcome = run(
        mesh, {.parts = {.count = 6, .runs = 20, .proxy = proxy}, .nets = {.compaction = false}});
    expect_sound(outcome);
    EXPECT_EQ(outcome.result->parts, 6);
    EXPECT_EQ(outcome.result->mesh.face_count(), mesh.face_count());
  }
}

TEST(Job, LabelsTheFacesOfTheFile) {
  // A cube of quads with a face that is only a line, which is dropped.
  const std::string text =
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
      "f 1 4 3 2\nf 5 6 7 8\nf 1 1 2\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
  const Outcome outcome = run_file(text, "cube.obj", {.parts = {.count = 3, .runs = 20}});
  expect_sound(outcome);
  const JobResult& result = *outcome.result;
  ASSERT_EQ(result.segmentation.size(), 7u);
  EXPECT_EQ(result.segmentation[2], -1);
  for (int face = 0; face < result.mesh.face_count(); ++face) {
    EXPECT_EQ(result.segmentation[result.mesh.source_faces[face]], result.labels[face]);
  }
}

TEST(Job, SaysBeforeTheSearchWhatALargeModelCosts) {
  const auto tells = [](const JobOptions& options) {
    Job job({{"model.obj", to_bytes(obj_of(torus(200, 100)))}}, options);  // 20,000 panels
    for (bool is_read = false; !is_read;) {
      for (const Event& event : job.step(kSlice)) {
        const auto* notice = std::get_if<Notice>(&event);
        if (notice != nullptr && notice->code == "large-model") return true;
        const auto* stage = std::get_if<StageEvent>(&event);
        is_read = is_read || (stage != nullptr && stage->stage != StageId::kRead);
      }
    }
    return false;
  };
  EXPECT_TRUE(tells({}));
  EXPECT_FALSE(tells({.model = {.faces = 1000}})) << "whoever asks for fewer knows";
}

TEST(Job, RefusesToSearchNetsThatWouldTakeHours) {
  const std::string model = obj_of(torus(450, 225));  // 101,250 panels
  const Outcome refused = run_file(model, "model.obj", {});
  ASSERT_EQ(refused.all<ErrorEvent>().size(), 1u);
  EXPECT_EQ(describe(refused.all<ErrorEvent>()[0].message),
            "too-many-faces faces=101250 most=100000 proposed=1500");
}

TEST(Job, HandsOnHowTheModelLooks) {
  const std::string model = obj_of(tetrahedron());
  const Outcome bare = run_file(model, "model.obj", {.parts = {.count = 1, .runs = 10}});
  expect_sound(bare);
  EXPECT_FALSE(bare.result->looks);
  const Outcome red = run_file("mtllib a.mtl\nusemtl red\n" + model, "model.obj",
                               {.parts = {.count = 1, .runs = 10}});
  expect_sound(red);
  ASSERT_TRUE(red.result->looks);
  EXPECT_EQ(red.result->looks->faces.materials, (std::vector<int>{0, 0, 0, 0}));
  EXPECT_EQ(red.result->looks->material_names, (std::vector<std::string>{"red"}));
  EXPECT_EQ(red.result->looks->libraries, (std::vector<std::string>{"a.mtl"}));
  EXPECT_FALSE(red.result->looks->original);
  EXPECT_EQ(red.result->hash, bare.result->hash) << "looks change no net";
}

TEST(Job, KeepsTheSurfaceThatLooksAreOfWhenItSimplifies) {
  const std::string model = "usemtl red\n" + obj_of(bumpy_sphere(200));
  const Outcome outcome =
      run_file(model, "model.obj", {.model = {.faces = 60}, .parts = {.count = 1, .runs = 10}});
  expect_sound(outcome);
  ASSERT_TRUE(outcome.result->looks);
  const ModelLooks& looks = *outcome.result->looks;
  ASSERT_TRUE(looks.original);
  EXPECT_GT(looks.original->faces.size(), outcome.result->mesh.faces.size());
  EXPECT_EQ(looks.faces.materials.size(), looks.original->faces.size());
}

}  // namespace
}  // namespace foldwright::testing
