#include "fold/motion.h"

#include <gtest/gtest.h>

namespace foldwright::testing {
namespace {

TEST(StraightMotion, TurnsAllFoldsTogether) {
  const FoldMotion motion = straight_motion({4, 7, 9});
  EXPECT_EQ(motion.kind, Folding::kLine);
  EXPECT_TRUE(motion.certified());
  EXPECT_EQ(motion.times, (std::vector<double>{0, 1}));
  EXPECT_EQ(shares_at(motion, 0), std::vector<double>(3, 0));
  EXPECT_EQ(shares_at(motion, 0.25), std::vector<double>(3, 0.25));
  EXPECT_EQ(shares_at(motion, 1), std::vector<double>(3, 1));
}

TEST(StraightMotion, OfOnePanelHasNoFolds) {
  const FoldMotion motion = straight_motion({});
  EXPECT_TRUE(motion.certified());
  EXPECT_TRUE(shares_at(motion, 0.5).empty());
}

TEST(MotionOver, HasItsKeysAtEvenTimes) {
  const FoldMotion motion = motion_over({{0, 0}, {1, 0}, {1, 0.5}, {0.75, 0.5}, {1, 1}});
  EXPECT_EQ(motion.kind, Folding::kWaypoints);
  EXPECT_TRUE(motion.certified());
  EXPECT_EQ(motion.times, (std::vector<double>{0, 0.25, 0.5, 0.75, 1}));
  for (std::size_t key = 0; key < motion.times.size(); ++key) {
    EXPECT_EQ(shares_at(motion, motion.times[key]), motion.shares[key]);
  }
  EXPECT_EQ(shares_at(motion, 0.125), (std::vector<double>{0.5, 0}));
  EXPECT_EQ(shares_at(motion, 0.375), (std::vector<double>{1, 0.25}));
  EXPECT_EQ(shares_at(motion, 0.875), (std::vector<double>{0.875, 0.75}));
}

TEST(MotionOver, ReachesItsLastKeyForAnyNumberOfThem) {
  for (int keys = 2; keys <= 50; ++keys) {
    std::vector<std::vector<double>> shares;
    for (int key = 0; key < keys; ++key) shares.push_back({static_cast<double>(key) / (keys - 1)});
    const FoldMotion motion = motion_over(shares);
    EXPECT_EQ(motion.kind, keys == 2 ? Folding::kLine : Folding::kWaypoints);
    EXPECT_EQ(motion.times.front(), 0);
    EXPECT_EQ(motion.times.back(), 1);
    for (int i = 0; i <= 100; ++i) {
      ASSERT_NEAR(shares_at(motion, 0.01 * i)[0], 0.01 * i, 1e-12);
    }
  }
}

TEST(FoldMotion, WithoutAMotionIsNotCertified) {
  EXPECT_FALSE(FoldMotion{}.certified());
  EXPECT_FALSE((FoldMotion{Folding::kNone, {}, {}}).certified());
}

}  // namespace
}  // namespace foldwright::testing
