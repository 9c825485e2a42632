// Whole jobs of shapes that people draw by hand, against what they draw.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>
#include <utility>

#include "job_runs.h"
#include "meshes.h"
#include "paper/seams.h"

namespace foldwright::testing {
namespace {

/// Length of all that is to be glued, in mm, and the number of seams.
struct Glue {
  double length = 0;
  int seams = 0;
};

Glue glue_of(const JobResult& result) {
  std::vector<Net> nets;
  for (const Piece& piece : result.pieces) nets.push_back(piece.net);
  Glue glue;
  for (const Seam& seam : find_seams(nets)) {
    glue.length += seam.sides[0].length();
    ++glue.seams;
  }
  return glue;
}

/// How often flaps change sides between seams that follow each other.
int changes_of_side(const JobResult& result) {
  std::vector<Net> nets;
  std::set<std::pair<int, int>> flaps;  // by net and first edge
  for (const Piece& piece : result.pieces) {
    for (const Flap& flap : piece.flaps) flaps.insert({static_cast<int>(nets.size()), flap.edge});
    nets.push_back(piece.net);
  }
  const std::vector<Seam> seams = find_seams(nets);
  int changes = 0;
  for (const std::vector<SeamStep>& chain : seam_chains(nets, seams)) {
    int last = -1;
    for (const auto& [seam, side] : chain) {
      for (const int bank : {0, 1}) {
        const SeamSide& at = seams[seam].sides[bank == 0 ? side : 1 - side];
        if (!flaps.contains({at.net, at.edge()})) continue;
        changes += last != -1 && last != bank;
        last = bank;
      }
    }
  }
  return changes;
}

/// A job at a height of 60 mm.
Outcome unfold(const Mesh& mesh) {
  JobOptions options;
  options.size = {Sizing::kHeight, 60};
  return run(mesh, options);
}

TEST(ShapeNets, OfACylinderAreAStripWithTwoLids) {
  const Outcome outcome = unfold(prism(32, 2));
  expect_sound(outcome);
  EXPECT_EQ(outcome.result->pieces.size(), 1u);
  const double side = 2 * std::sin(std::numbers::pi / 32) * 30;
  const double by_hand = 60 + 2 * 31 * side;
  EXPECT_LE(glue_of(*outcome.result).length, 1.1 * by_hand);
  EXPECT_LE(changes_of_side(*outcome.result), 6) << "both lids are glued round in one go";
}

TEST(ShapeNets, OfAGridCubeHaveTheSeamsOfACube) {
  const Outcome outcome = unfold(grid_cube(4));
  expect_sound(outcome);
  EXPECT_EQ(glue_of(*outcome.result).seams, 7);
  EXPECT_NEAR(glue_of(*outcome.result).length, 7 * 60, 1e-6);
  EXPECT_EQ(outcome.result->pieces[0].flaps.size(), 7u);
}

TEST(ShapeNets, OfAnExtrudedLAreOnePiece) {
  const Outcome outcome = unfold(l_prism());
  expect_sound(outcome);
  EXPECT_LE(outcome.result->pieces.size(), 2u);
}

}  // namespace
}  // namespace foldwright::testing
