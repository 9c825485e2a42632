#include "repair/repair_steps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <span>

#include "mesh/input_error.h"
#include "meshes.h"
#include "pipeline/values/options.h"
#include "random_soup.h"
#include "sound_repair.h"

namespace foldwright::testing {
namespace {

RepairSteps steps(std::initializer_list<RepairStep> off) {
  RepairSteps chosen;
  for (const RepairStep step : off) chosen.set(static_cast<std::size_t>(step));
  return chosen;
}

RepairedModel without(const PolygonSoup& soup, std::initializer_list<RepairStep> off) {
  return sound_repair(soup, {.off = steps(off)});
}

/// To how many things a step would have been done that is off; 0 if nothing is told of it.
int undone(const RepairedModel& model, RepairStep step) {
  const std::string name(kRepairSteps[static_cast<std::size_t>(step)].name);
  for (const Repair& repair : model.repairs) {
    const Parameters& more = repair.parameters;
    if (repair.code == "step-off" && more == Parameters{{"what", name}}) return repair.count;
  }
  return 0;
}

/// A mesh as STL files have it: every triangle with corners of its own.
PolygonSoup apart(const Mesh& mesh) {
  std::vector<Vec3> positions;
  std::vector<std::vector<int>> triangles;
  for (const auto& face : mesh.faces) {
    const int first = static_cast<int>(positions.size());
    for (const int v : face) positions.push_back(mesh.positions[v]);
    triangles.push_back({first, first + 1, first + 2});
  }
  return soup(positions, triangles);
}

/// A tetrahedron whose edge 0-1 has a further vertex on it, as a face beside it does not know.
PolygonSoup with_t_junction() {
  return soup({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {1, 0, 0}},
              {{0, 2, 1}, {0, 4, 3}, {4, 1, 3}, {0, 3, 2}, {1, 2, 3}});
}

/// Two panels of a tent 60 long, whose ridges lie 0.002 apart.
PolygonSoup with_crack() {
  return soup({{0, 0, 0},
               {60, 0, 0},
               {60, 30, 25},
               {0, 30, 25},
               {60, 30, 25.002},
               {0, 30, 25.002},
               {60, 0, 50},
               {0, 0, 50}},
              {{0, 1, 2, 3}, {5, 4, 6, 7}});
}

/// A square with a square of its own behind it, turned to the other side.
PolygonSoup front_and_back() {
  return soup({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}, {3, 2, 1, 0}});
}

TEST(RepairSteps, WeldCanBeOff) {
  const PolygonSoup loose = apart(cube());
  EXPECT_EQ(count_of(sound_repair(loose), "welded-vertices"), 36 - 8);
  // The gaps between faces that are not welded are cracks without a width.
  const RepairedModel cracked = without(loose, {RepairStep::kWeld});
  EXPECT_EQ(undone(cracked, RepairStep::kWeld), 36 - 8);
  EXPECT_EQ(count_of(cracked, "welded-vertices"), 0);
  EXPECT_EQ(count_of(cracked, "closed-cracks"), 36);
  EXPECT_EQ(border_edge_count(cracked.mesh), 0);
  const RepairedModel pieces = without(loose, {RepairStep::kWeld, RepairStep::kCracks});
  EXPECT_EQ(pieces.mesh.component_count, 12);
  EXPECT_EQ(undone(pieces, RepairStep::kCracks), 36);
  EXPECT_EQ(count_of(pieces, "open-border"), 36);
}

TEST(RepairSteps, DuplicatesCanBeOff) {
  const PolygonSoup doubled =
      soup({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}, {1, 2, 3, 0}});
  EXPECT_EQ(count_of(sound_repair(doubled), "dropped-duplicate-faces"), 1);
  const RepairedModel model = without(doubled, {RepairStep::kDuplicates});
  EXPECT_EQ(undone(model, RepairStep::kDuplicates), 1);
  EXPECT_EQ(count_of(model, "dropped-duplicate-faces"), 0);
  EXPECT_EQ(count_of(model, "dropped-degenerate-faces"), 0);
  // Both squares are there, and joined all around.
  EXPECT_NEAR(area_of(model.mesh), 2, 1e-12);
  EXPECT_EQ(count_of(model, "flat-bodies"), 1);
}

TEST(RepairSteps, TwoSidedCanBeOff) {
  EXPECT_EQ(count_of(sound_repair(front_and_back()), "merged-two-sided"), 1);
  const RepairedModel model = without(front_and_back(), {RepairStep::kTwoSided});
  EXPECT_EQ(undone(model, RepairStep::kTwoSided), 1);
  EXPECT_EQ(count_of(model, "merged-two-sided"), 0);
  EXPECT_GE(model.mesh.face_count(), 4);
  EXPECT_EQ(border_edge_count(model.mesh), 0);
}

TEST(RepairSteps, JunctionsCanBeOff) {
  EXPECT_EQ(count_of(sound_repair(with_t_junction()), "closed-t-junctions"), 1);
  const RepairedModel model =
      without(with_t_junction(), {RepairStep::kJunctions, RepairStep::kCracks});
  EXPECT_EQ(undone(model, RepairStep::kJunctions), 1);
  EXPECT_EQ(border_edge_count(model.mesh), 3);
  EXPECT_EQ(model.mesh.face_count(), 5);
}

TEST(RepairSteps, CracksCanBeOff) {
  const RepairedModel model = without(with_crack(), {RepairStep::kCracks});
  EXPECT_EQ(undone(model, RepairStep::kCracks), 2);
  EXPECT_EQ(count_of(model, "closed-cracks"), 0);
  EXPECT_EQ(model.mesh.component_count, 2);
  EXPECT_EQ(model.largest_move, 0);
}

TEST(RepairSteps, WindingOfTheFileCanBeKept) {
  PolygonSoup spoilt = soup_of(cube());
  std::swap(spoilt.corners[0], spoilt.corners[1]);
  EXPECT_EQ(count_of(sound_repair(spoilt), "flipped-faces"), 1);
  const RepairedModel model = without(spoilt, {RepairStep::kWinding});
  EXPECT_EQ(undone(model, RepairStep::kWinding), 1);
  EXPECT_EQ(count_of(model, "flipped-faces"), 0);
  EXPECT_EQ(model.mesh.component_count, 2);
  EXPECT_EQ(border_edge_count(model.mesh), 6);

  PolygonSoup inside_out = soup_of(cube());
  for (int f = 0; f < inside_out.face_count(); ++f) {
    std::swap(inside_out.corners[3 * f], inside_out.corners[3 * f + 1]);
  }
  EXPECT_NEAR(signed_volume(sound_repair(inside_out).mesh), 1, 1e-12);
  const RepairedModel kept = without(inside_out, {RepairStep::kWinding});
  EXPECT_NEAR(signed_volume(kept.mesh), -1, 1e-12);
  EXPECT_EQ(undone(kept, RepairStep::kWinding), 12);
  EXPECT_EQ(border_edge_count(kept.mesh), 0);
}

TEST(RepairSteps, BodiesInsideOthersAreFoundHoweverTheFileWindsThem) {
  PolygonSoup nested = soup_of(cube());
  const Mesh inner = cube();
  for (const auto& [a, b, c] : inner.faces) {
    for (const int corner : {a, c, b}) nested.corners.push_back(corner + 8);
    nested.first_corner.push_back(static_cast<int>(nested.corners.size()));
  }
  for (const Vec3& p : inner.positions) nested.positions.push_back(0.5 * p);
  const RepairedModel model = without(nested, {RepairStep::kWinding});
  EXPECT_EQ(count_of(model, "inner-bodies"), 1);
  EXPECT_EQ(undone(model, RepairStep::kWinding), 0);
  const RepairOptions dropping = {.drop_inner = true, .off = steps({RepairStep::kWinding})};
  EXPECT_EQ(sound_repair(nested, dropping).mesh.face_count(), 12);
}

TEST(RepairSteps, FlatteningCanBeOff) {
  // A square of four corners, one of which the three decimals of the file put a little aside.
  PolygonSoup bent = soup({{0, 0, 0.001}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}}, {{0, 1, 2, 3}});
  bent.precision = 0.001;
  EXPECT_EQ(count_of(sound_repair(bent), "flattened-faces"), 1);
  const RepairedModel model = without(bent, {RepairStep::kFlatten});
  EXPECT_EQ(undone(model, RepairStep::kFlatten), 1);
  EXPECT_EQ(count_of(model, "flattened-faces"), 0);
  EXPECT_EQ(model.largest_move, 0);
}

TEST(RepairSteps, StepsWithNothingToDoAreNotTold) {
  const RepairedModel model = sound_repair(soup_of(star()), {.off = RepairSteps().set()});
  EXPECT_TRUE(model.repairs.empty());
}

TEST(RepairSteps, EverythingStaysAManifoldWithoutThem) {
  for (std::uint64_t seed = 1; seed <= 120; ++seed) {
    const PolygonSoup soup = random_soup(seed);
    for (std::size_t i = 0; i <= kRepairSteps.size(); ++i) {
      if (i < kRepairSteps.size() && kRepairSteps[i].kind != StepKind::kSwitch) continue;
      SCOPED_TRACE("seed " + std::to_string(seed) + ", step " + std::to_string(i));
      RepairOptions options;
      for (std::size_t k = 0; k < kRepairSteps.size(); ++k) {
        // The last round goes without any of them.
        const bool is_meant = i == k || i == kRepairSteps.size();
        options.off[k] = is_meant && kRepairSteps[k].kind == StepKind::kSwitch;
      }
      try {
        sound_repair(soup, options);
      } catch (const InputError& error) {
        EXPECT_TRUE(error.code() == "no-area" || error.code() == "no-faces") << error.what();
      }
    }
  }
}

TEST(RepairSteps, OnlySwitchesCanBeOff) {
  for (std::size_t i = 0; i < kRepairSteps.size(); ++i) {
    JobOptions options;
    options.model.off.set(i);
    if (kRepairSteps[i].kind == StepKind::kSwitch) {
      EXPECT_NO_THROW(check_options(options));
    } else {
      EXPECT_THROW(check_options(options), InputError) << kRepairSteps[i].name;
    }
  }
}

TEST(Repair, TellsOfBodiesWithoutAVolume) {
  const RepairedModel closed = without(front_and_back(), {RepairStep::kTwoSided});
  EXPECT_EQ(count_of(closed, "flat-bodies"), 1);
  EXPECT_EQ(count_of(closed, "open-border"), 0);
  const Repair open = repair_named(sound_repair(soup_of(open_strip(3))).repairs, "open-border");
  ASSERT_EQ(open.parameters.size(), 2u);
  EXPECT_EQ(open.parameters[1], Parameter("bodies", 1));
  EXPECT_EQ(count_of(sound_repair(soup_of(cube())), "flat-bodies"), 0);
}

}  // namespace
}  // namespace foldwright::testing
