#include "paper/recut.h"

#include <gtest/gtest.h>

namespace foldwright::testing {
namespace {

/// Unit squares in a row, each folded to the next.
Plates row_of_squares(int count) {
  Plates plates;
  for (int i = 0; i < count; ++i) {
    const double x = i;
    plates.corners.push_back({{x, 0}, {x + 1, 0}, {x + 1, 1}, {x, 1}});
    plates.areas.push_back(1);
    if (i > 0) plates.folds.push_back({i - 1, i});
  }
  return plates;
}

TEST(ChooseCut, HalvesWhatFitsThen) { EXPECT_EQ(choose_cut(row_of_squares(6), {3.2, 1.2}), 2); }

TEST(ChooseCut, TakesNoMorePiecesThanItMust) {
  // Seven squares need three pieces of up to three, so the first cut leaves a piece that is whole.
  const int cut = choose_cut(row_of_squares(7), {3.2, 1.2});
  const int left = cut + 1;
  EXPECT_LE((left + 2) / 3 + (7 - left + 2) / 3, 3);
}

TEST(ChooseCut, KeepsToTheFoldsOfATree) {
  // A comb: the long arm is too long for the room, so cutting off the short one helps nothing.
  Plates comb = row_of_squares(4);
  comb.corners.push_back({{0, 1}, {1, 1}, {1, 2}, {0, 2}});
  comb.areas.push_back(1);
  comb.folds.push_back({0, 4});
  const int cut = choose_cut(comb, {3.2, 2.2});
  EXPECT_TRUE(cut == 0 || cut == 1) << cut;
}

/// Squares that fold around each other in a spiral, `turns` times.
Plates spiral(int turns) {
  Plates plates;
  Vec2 at(0, 0);
  Vec2 step(1, 0);
  for (int run = 1; run <= 2 * turns; ++run) {
    for (int i = 0; i < run; ++i) {
      plates.corners.push_back({at, at + Vec2(1, 0), at + Vec2(1, 1), at + Vec2(0, 1)});
      plates.areas.push_back(1);
      const auto last = static_cast<int>(plates.areas.size()) - 1;
      if (last > 0) plates.folds.push_back({last - 1, last});
      at += step;
    }
    step = Vec2(-step.y(), step.x());
  }
  return plates;
}

TEST(ChooseCut, EndsSoonWherePiecesComeByTheHundred) {
  // Looked at to the end, all ways to cut it take hours.
  const Plates plates = spiral(7);
  ASSERT_LE(plates.areas.size(), 250u);
  const int cut = choose_cut(plates, {1.2, 1.2});
  EXPECT_GE(cut, 0);
  EXPECT_LT(cut, static_cast<int>(plates.folds.size()));
}

}  // namespace
}  // namespace foldwright::testing
