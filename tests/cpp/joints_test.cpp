#include "repair/joints.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "job_runs.h"
#include "read/read_model.h"
#include "repair/repair.h"

namespace foldwright::testing {
namespace {

/// A box from -1 to 1 whose upper side is two rectangles, so that it has an edge in its middle.
const std::string kBox =
    "v -1 -1 -1\nv 1 -1 -1\nv 1 -1 1\nv -1 -1 1\nv -1 1 -1\nv 1 1 -1\nv 1 1 1\nv -1 1 1\n"
    "v 0 1 -1\nv 0 1 1\n"
    "f 1 2 3 4\nf 1 5 9 6 2\nf 2 6 7 3\nf 3 7 10 8 4\nf 4 8 5 1\nf 5 8 10 9\nf 9 10 7 6\n";

/// A fin on the middle of its upper side, and one on its upper edge at x = 1.
const std::string kFin = "v 0 2 -1\nv 0 2 1\nf 9 11 12 10\n";
const std::string kRim = "v 2 2 -1\nv 2 2 1\nf 6 11 12 7\n";

Mesh mesh_of(const std::string& obj) {
  return repair(read_model(std::as_bytes(std::span(obj)), "model.obj")).mesh;
}

TEST(Joints, AreWhereAFinStandsOnAClosedBody) {
  for (const std::string& fin : {kFin, kRim}) {
    const Mesh mesh = mesh_of(kBox + fin);
    ASSERT_EQ(mesh.joints.size(), 1u);
    const auto& [edge, host] = mesh.joints[0];
    EXPECT_EQ(mesh.edges[edge].faces[1], -1) << "the fin's foot is a border";
    EXPECT_NE(mesh.edges[host].faces[1], -1) << "the box stays closed";
    EXPECT_NE(mesh.components[mesh.edges[edge].faces[0]],
              mesh.components[mesh.edges[host].faces[0]]);
  }
}

TEST(Joints, AreNoneOfBodiesThatShareAnEdge) {
  EXPECT_TRUE(mesh_of(kBox).joints.empty());
  // A second cube touches the first along the edge from (1, 1, -1) to (1, 1, 1) only.
  const std::string cube =
      "v 1 3 -1\nv 1 3 1\nv 3 1 -1\nv 3 1 1\nv 3 3 -1\nv 3 3 1\n"
      "f 6 7 12 11\nf 6 13 14 7\nf 13 15 16 14\nf 11 12 16 15\nf 6 11 15 13\nf 7 14 16 12\n";
  const Mesh mesh = mesh_of(kBox + cube);
  EXPECT_EQ(mesh.component_count, 2);
  EXPECT_TRUE(mesh.joints.empty());
}

TEST(Joints, StandOnOneOfThreeWallsThatMeet) {
  const Mesh mesh = mesh_of(
      "v 0 0 0\nv 0 1 0\nv 1 0 0\nv 1 1 0\nv -1 0 1\nv -1 1 1\nv -1 0 -1\nv -1 1 -1\n"
      "f 1 3 4 2\nf 1 2 6 5\nf 1 7 8 2\n");
  EXPECT_EQ(mesh.joints.size(), 1u);
}

std::size_t count_texts(const JobResult& result, const std::string& text) {
  std::size_t count = 0;
  for (const Piece& piece : result.pieces) {
    count += std::ranges::count(piece.labels, text, &Label::text);
  }
  return count;
}

TEST(Joints, AreNumberedAtBothSidesWithAFlapAndALine) {
  const Outcome outcome =
      run_file(kBox + kFin, "model.obj", {.parts = {.count = 2}, .nets = {.compaction = false}});
  expect_sound(outcome);
  const JobResult& result = *outcome.result;
  EXPECT_TRUE(outcome.notices().contains("joints"));
  std::size_t lines = 0;
  for (const Piece& piece : result.pieces) {
    for (const auto& [from, to] : piece.joint_lines) {
      ++lines;
      const double length = (to - from).norm();
      EXPECT_NEAR(length, 2 * result.sheets.scale, 1) << "as long as the fin's foot";
    }
  }
  EXPECT_EQ(lines, 1u);
  EXPECT_EQ(result.flap_counts.borders, 1);
  std::vector<double> feet;  // bends of flaps at borders
  for (const Piece& piece : result.pieces) {
    for (const Flap& flap : piece.flaps) {
      const int edge = piece.net.edges[flap.edge].mesh_edge;
      if (result.mesh.edges[edge].faces[1] == -1) feet.push_back(flap.angle);
    }
  }
  ASSERT_EQ(feet.size(), 1u);
  EXPECT_NEAR(std::abs(feet[0]), 0.5 * std::numbers::pi, 1e-9) << "the fin stands upright";
  EXPECT_TRUE(result.skipped_ids.empty());
  EXPECT_EQ(count_texts(result, "A1"), 1u) << "on the flap of the fin";
  EXPECT_EQ(count_texts(result, "B1"), 1u) << "beside the line on the box";
}

TEST(Joints, DrawNoLineWhereAFoldIsDrawn) {
  const Outcome outcome =
      run_file(kBox + kRim, "model.obj", {.parts = {.count = 2}, .nets = {.compaction = false}});
  expect_sound(outcome);
  for (const Piece& piece : outcome.result->pieces) EXPECT_TRUE(piece.joint_lines.empty());
  EXPECT_TRUE(outcome.result->skipped_ids.empty());
}

TEST(Joints, HaveNoFlapsWhereNoneAreWanted) {
  JobOptions options{.parts = {.count = 2}, .nets = {.compaction = false}};
  options.paper.flaps.side = FlapSide::kNone;
  const Outcome outcome = run_file(kBox + kFin, "model.obj", options);
  expect_sound(outcome);
  for (const Piece& piece : outcome.result->pieces) EXPECT_TRUE(piece.flaps.empty());
}

}  // namespace
}  // namespace foldwright::testing
