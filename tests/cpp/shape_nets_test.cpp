// Whole jobs of shapes that people draw by hand, against what they draw.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "craft_shapes.h"
#include "drawn_shapes.h"
#include "job_runs.h"
#include "paper/grain.h"
#include "seam_counts.h"

namespace foldwright::testing {
namespace {

/// A job at a height of 60 mm.
Outcome unfold(const Mesh& mesh) {
  JobOptions options;
  options.paper.size = {Sizing::kHeight, 60};
  return run(mesh, options);
}

TEST(ShapeNets, OfACylinderAreAStripWithTwoLids) {
  const Outcome outcome = unfold(prism(32, 2));
  expect_sound(outcome);
  EXPECT_EQ(outcome.result->pieces.size(), 1u);
  const double side = 2 * std::sin(std::numbers::pi / 32) * 30;
  const double by_hand = 60 + 2 * 31 * side;
  EXPECT_LE(count_seams(*outcome.result).glue, 1.1 * by_hand);
  EXPECT_LE(count_seams(*outcome.result).within.changes, 6)
      << "both lids are glued round in one go";
}

TEST(ShapeNets, OfAGridCubeHaveTheSeamsOfACube) {
  const Outcome outcome = unfold(grid_cube(4));
  expect_sound(outcome);
  EXPECT_EQ(count_seams(*outcome.result).seams, 7);
  EXPECT_NEAR(count_seams(*outcome.result).glue, 7 * 60, 1e-6);
  EXPECT_EQ(outcome.result->pieces[0].flaps.size(), 7u);
}

TEST(ShapeNets, OfAnExtrudedLAreOnePiece) {
  const Outcome outcome = unfold(l_prism());
  expect_sound(outcome);
  EXPECT_LE(outcome.result->pieces.size(), 2u);
}

TEST(ShapeNets, LieAlongTheSheetAlsoWhereTheyFillIt) {
  int seen = 0;
  for (const CraftShape& shape : craft_shapes()) {
    if (shape.solid.name != "house" && shape.solid.name != "prism 6") continue;
    ++seen;
    SCOPED_TRACE(shape.solid.name);
    const Outcome outcome = run_file(obj_of(shape.solid), "model.obj", {});
    expect_sound(outcome);
    for (const Piece& piece : outcome.result->pieces) {
      const auto grain = grain_of(piece.net);
      ASSERT_TRUE(grain);
      EXPECT_NEAR(std::sin(2 * *grain), 0, 1e-6);
    }
  }
  EXPECT_EQ(seen, 2);
}

}  // namespace
}  // namespace foldwright::testing
