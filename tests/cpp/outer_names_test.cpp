#include "paper/outer_names.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "craft_shapes.h"
#include "geometry/convex2.h"
#include "job_runs.h"
#include "pipeline/sheets/flat_net.h"

namespace foldwright::testing {
namespace {

Footprint triangle(double size) {
  return {{{Vec2(0, 0), Vec2(size, 0), Vec2(0, size)}}, size * size / 2};
}

/// Pieces on one sheet of A4 at these places.
SheetLayout layout_of(const std::vector<Vec2>& places) {
  SheetLayout layout;
  layout.sheet_width = 210;
  layout.sheet_height = 297;
  layout.sheet_count = 1;
  for (const Vec2& p : places) layout.placements.push_back({0, p.x(), p.y()});
  return layout;
}

LabelPlan nameless(std::size_t pieces) {
  LabelPlan plan;
  plan.labels.resize(pieces);
  return plan;
}

/// What a text covers, from the lower left of its piece.
std::vector<Vec2> box_of_text(const Label& label) {
  const TextBox box = box_around(label.text, {label.size}, label.centre, Vec2(1, 0));
  const auto corners = box.corners();
  return {corners.begin(), corners.end()};
}

TEST(WriteOuterNames, WritesBesideTinyPiecesAndOnNothing) {
  // In rows as close as pieces are packed.
  std::vector<Footprint> pieces;
  std::vector<Vec2> places;
  std::vector<std::string> names;
  for (int i = 0; i < 20; ++i) {
    pieces.push_back(triangle(4));
    places.emplace_back(12 + 7 * (i % 5), 200 - 7 * (i / 5));
    names.push_back(piece_letter(i));
  }
  const SheetLayout layout = layout_of(places);
  LabelPlan plan = nameless(pieces.size());
  SheetObstacles sheets(pieces, layout, {}, {});
  write_outer_names({sheets, names}, plan);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    SCOPED_TRACE(names[i]);
    ASSERT_EQ(plan.labels[i].size(), 1u);
    const Label& label = plan.labels[i][0];
    EXPECT_EQ(label.text, names[i]);
    EXPECT_TRUE(label.is_beside);
    EXPECT_GE(label.size, 2);
    ASSERT_TRUE(label.leader);
    EXPECT_LT((label.leader->to - label.leader->from).norm(), 8.1);
    std::vector<Vec2> text = box_of_text(label);
    for (Vec2& p : text) p += places[i];
    for (std::size_t j = 0; j < pieces.size(); ++j) {
      std::vector<Vec2> polygon = pieces[j].polygons[0];
      for (Vec2& p : polygon) p += places[j];
      EXPECT_FALSE(convex_overlap(text, polygon, 0)) << "on " << names[j];
      if (j == i) continue;
      std::vector<Vec2> other = box_of_text(plan.labels[j][0]);
      for (Vec2& p : other) p += places[j];
      EXPECT_FALSE(convex_overlap(text, other, 0)) << "over " << names[j];
    }
  }
}

TEST(WriteOuterNames, KeepsWithinThePrintablePartOfTheSheet) {
  const std::vector<Footprint> pieces = {triangle(4)};
  const std::vector<std::string> names = {"Wing"};
  const SheetOptions options;
  const double low = ruled_margin(options);
  for (const Vec2& corner : {Vec2(low, low), Vec2(196, low), Vec2(low, 283), Vec2(196, 283)}) {
    const SheetLayout layout = layout_of({corner});
    LabelPlan plan = nameless(1);
    SheetObstacles sheets(pieces, layout, options, {});
    write_outer_names({sheets, names}, plan);
    ASSERT_EQ(plan.labels[0].size(), 1u);
    for (const Vec2& p : box_of_text(plan.labels[0][0])) {
      const Vec2 at = p + corner;
      EXPECT_GE(std::min(at.x(), at.y()), low - 1e-9);
      EXPECT_LE(at.x(), 200 + 1e-9);
      EXPECT_LE(at.y(), 287 + 1e-9);
    }
  }
}

TEST(WriteOuterNames, LeavesNamesThatStandOnTheirPieces) {
  const std::vector<Footprint> pieces = {triangle(50)};
  const std::vector<std::string> names = {"A"};
  const SheetLayout layout = layout_of({{20, 20}});
  LabelPlan plan = nameless(1);
  plan.labels[0].push_back({"A", {10, 10}, 0, 6});
  SheetObstacles sheets(pieces, layout, {}, {});
  write_outer_names({sheets, names}, plan);
  EXPECT_EQ(plan.labels[0].size(), 1u);
  EXPECT_FALSE(plan.labels[0][0].is_beside);
}

TEST(WriteOuterNames, LeaveNoPieceOfAJobWithoutAName) {
  // A box and a dozen studs of 3 mm that are too small for any letter.
  std::vector<Solid> solids(13, craft_shapes()[0].solid);
  for (int i = 1; i < 13; ++i) {
    for (Vec3& p : solids[i].positions) p = 0.05 * p + Vec3(10 * i, 0, 70);
  }
  JobOptions options;
  options.paper.size = {Sizing::kScale, 1, Unit::kMillimetre};
  const Outcome outcome = run_file(obj_of(together("", solids)), "studs.obj", options);
  expect_sound(outcome);
  EXPECT_EQ(outcome.result->pieces.size(), 13u);
  int beside = 0;
  for (const Piece& piece : outcome.result->pieces) {
    ASSERT_FALSE(piece.labels.empty());
    EXPECT_EQ(piece.labels[0].text, piece.name);
    beside += piece.labels[0].is_beside;
  }
  EXPECT_EQ(beside, 12);
}

}  // namespace
}  // namespace foldwright::testing
