#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <span>

#include "job_runs.h"
#include "meshes.h"
#include "pipeline/sheets/model_size.h"
#include "segment/spectral.h"
#include "shared_models.h"

namespace foldwright::testing {
namespace {

JobOptions sized(Sizing by, double value, int parts) {
  JobOptions options;
  options.parts.count = parts;
  options.parts.runs = 60;
  options.paper.size = {by, value};
  return options;
}

void expect_all_fit(const JobResult& result, const SheetOptions& sheet) {
  std::vector<int> uses(result.mesh.faces.size(), 0);
  for (const Piece& piece : result.pieces) {
    EXPECT_TRUE(piece.check.valid());
    EXPECT_TRUE(fits_somehow(Footprint{{piece.net.vertices}}, printable(sheet)));
    for (const int face : piece.net.faces) ++uses[face];
  }
  EXPECT_EQ(std::ranges::count(uses, 1), static_cast<int>(uses.size()));
}

bool has_notice(const JobResult& result, const std::string& code) {
  return std::ranges::any_of(result.notices, [&](const Notice& n) { return n.code == code; });
}

TEST(JobSize, IsTheHeightWidthOrDepthAskedFor) {
  const Mesh mesh = bumpy_sphere(200);
  const std::pair<Sizing, int> directions[] = {
      {Sizing::kWidth, 0}, {Sizing::kHeight, 1}, {Sizing::kDepth, 2}};
  for (const auto& [by, axis] : directions) {
    const Outcome outcome = run(mesh, sized(by, 80, 2));
    ASSERT_TRUE(outcome.result);
    const Vec3 size = extents(outcome.result->mesh) * outcome.result->sheets.scale;
    EXPECT_NEAR(size[axis], 80, 1e-9);
    EXPECT_FALSE(has_notice(*outcome.result, "sheet-split"));
  }
}

/// As an STL file: triangles without shared corners.
std::string stl_of(const Mesh& mesh) {
  std::string text = "solid\n";
  for (const auto& face : mesh.faces) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const int v : face) {
      const Vec3& p = mesh.positions[v];
      text += "vertex " + std::to_string(p.x()) + " " + std::to_string(p.y()) + " " +
              std::to_string(p.z()) + "\n";
    }
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid\n";
}

/// A box of 60 x 40 x 100.
Mesh tall_box() {
  Mesh mesh = cube();
  for (Vec3& p : mesh.positions) p = Vec3(60 * p.x(), 40 * p.y(), 100 * p.z());
  return mesh;
}

TEST(JobSize, TurnsTheAxisAskedForUp) {
  const std::pair<Up, Vec3> cases[] = {
      {Up::kX, Vec3(40, 60, 100)}, {Up::kY, Vec3(60, 40, 100)}, {Up::kZ, Vec3(60, 100, 40)}};
  for (const auto& [up, size] : cases) {
    JobOptions options{.model = {.up = up}, .parts = {.count = 1}};
    const Outcome outcome = run(tall_box(), options);
    expect_sound(outcome);
    EXPECT_LT((extents(outcome.result->mesh) - size).norm(), 1e-9);
    EXPECT_FALSE(has_notice(*outcome.result, "up-guessed"));
  }
}

TEST(JobSize, GuessesWhatIsUpFromTheFormatAndSaysSo) {
  JobOptions options = sized(Sizing::kHeight, 60, 1);
  const Outcome stl = run_file(stl_of(tall_box()), "box.stl", options);
  expect_sound(stl);
  const double scale = stl.result->sheets.scale;
  EXPECT_LT((extents(stl.result->mesh) * scale - Vec3(36, 60, 24)).norm(), 1e-9);
  EXPECT_TRUE(has_notice(*stl.result, "up-guessed"));
  const Outcome obj = run(tall_box(), options);
  expect_sound(obj);
  EXPECT_NEAR(extents(obj.result->mesh).y() * obj.result->sheets.scale, 60, 1e-9);
  EXPECT_NEAR(extents(obj.result->mesh).y(), 40, 1e-9);
  EXPECT_FALSE(has_notice(*obj.result, "up-guessed"));
}

TEST(JobSize, CutsAgainWhatIsTooLargeForTheSheet) {
  const Outcome outcome = run(bumpy_sphere(300), sized(Sizing::kHeight, 250, 2));
  ASSERT_TRUE(outcome.result);
  const JobResult& result = *outcome.result;
  expect_all_fit(result, {});
  EXPECT_GT(result.pieces.size(), 2u);
  EXPECT_EQ(result.parts, 2);
  EXPECT_TRUE(has_notice(result, "sheet-split"));
  for (const Piece& piece : result.pieces) {
    EXPECT_EQ(piece.cause, Cause::kSheet);
    EXPECT_EQ(piece.motion.kind, Folding::kLine) << "a cut leaves the motion what it was";
    for (const std::vector<double>& key : piece.motion.angles) {
      EXPECT_EQ(key.size(), piece.net.edges.size());
    }
  }
}

int parts_by_auto(const Mesh& mesh, const SizeOptions& size) {
  JobOptions options{.parts = {.count = 0, .runs = 60}, .nets = {.compaction = false}};
  options.paper.size = size;
  const Outcome outcome = run(mesh, options);
  expect_sound(outcome);
  return outcome.result->parts;
}

TEST(JobSize, AsksForMorePartsWhereSheetsNeedThem) {
  for (const Mesh& mesh : {bumpy_sphere(300), dumbbell(), random_hull(5, 200)}) {
    SCOPED_TRACE(mesh.face_count());
    const int fitting = parts_by_auto(mesh, {});
    EXPECT_EQ(parts_by_auto(mesh, {Sizing::kSheets, 2}), fitting);
    EXPECT_EQ(parts_by_auto(mesh, {Sizing::kHeight, 60}), fitting);
    const int large = parts_by_auto(mesh, {Sizing::kHeight, 250});
    EXPECT_GT(large, fitting);
    EXPECT_LE(large, kMostEstimatedParts);
    EXPECT_GE(parts_by_auto(mesh, {Sizing::kHeight, 350}), large);
  }
}

TEST(JobSize, LeavesANumberThatIsAskedForAlone) {
  const Outcome outcome = run(dumbbell(), sized(Sizing::kHeight, 400, 2));
  ASSERT_TRUE(outcome.result);
  EXPECT_EQ(outcome.result->parts, 2);
}

TEST(JobSize, IsTheLargestThatGoesOnSoManySheets) {
  const Mesh mesh = bumpy_sphere(200);
  double last = 0;
  for (const int sheets : {1, 2, 4}) {
    const Outcome outcome = run(mesh, sized(Sizing::kSheets, sheets, 3));
    ASSERT_TRUE(outcome.result);
    expect_all_fit(*outcome.result, {});
    EXPECT_LE(outcome.result->sheets.sheet_count, sheets);
    EXPECT_GT(outcome.result->sheets.scale, last);
    last = outcome.result->sheets.scale;
  }
}

TEST(JobSize, SaysWhatUnitItGuessed) {
  EXPECT_TRUE(has_notice(*run(cube(), sized(Sizing::kScale, 0.05, 1)).result, "unit-guessed"));
  JobOptions options = sized(Sizing::kScale, 40, 1);
  options.paper.size.unit = Unit::kMillimetre;
  const Outcome outcome = run(cube(), options);
  EXPECT_FALSE(has_notice(*outcome.result, "unit-guessed"));
  EXPECT_NEAR(outcome.result->sheets.scale, 40, 1e-12);
}

TEST(JobSize, RefusesFacesLargerThanASheet) {
  const Outcome outcome = run(cube(), sized(Sizing::kHeight, 500, 1));
  ASSERT_EQ(outcome.all<ErrorEvent>().size(), 1u);
  EXPECT_EQ(outcome.all<ErrorEvent>()[0].message.code, "face-too-large");
  // No search helps, so that none is waited for.
  EXPECT_TRUE(outcome.all<LearnedEvent>().empty());
}

TEST(JobSize, KeepsFlapsOnASheetThatAPieceFitsInOneTurnOnly) {
  // At 150 mm one of its pieces fits the sheet in a turn along no side of its hull with flaps.
  const auto path = shared_folder() / "models/textured/spot/spot_control_mesh.obj";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << kNoSharedModels;
  const SheetOptions sheet;
  for (const double height : {149.0, 150.0, 151.0}) {
    SCOPED_TRACE(height);
    const Outcome outcome =
        run_file(bytes_of(path), "spot.obj",
                 {.parts = {.count = 8}, .paper = {.size = {Sizing::kHeight, height}}});
    expect_sound(outcome);
    expect_all_fit(*outcome.result, sheet);
  }
}

}  // namespace
}  // namespace foldwright::testing
