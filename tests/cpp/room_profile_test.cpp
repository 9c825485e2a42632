#include "paper/room_profile.h"

#include <gtest/gtest.h>

#include <cmath>

#include "nets.h"

namespace foldwright::testing {
namespace {

constexpr double kCot60 = 0.57735026918962576;

TEST(BestFlap, IsFullWhereNothingIsInTheWay) {
  const auto flap = best_flap(open_room(20, 5), triangle_cover(20, {10, 30}).lean, {});
  ASSERT_TRUE(flap);
  EXPECT_EQ(flap->height, 5);
  EXPECT_EQ(flap->foot[0], 0);
  EXPECT_EQ(flap->foot[1], 20);
  EXPECT_NEAR(flap->top[0], 5 * kCot60, 1e-12);
  EXPECT_NEAR(flap->top[1], 20 - 5 * kCot60, 1e-12);
}

TEST(BestFlap, StaysWithinAFlatNeighbour) {
  // Corners of 45 degrees, so that the sides are flatter than the 60 that are allowed.
  const auto flap = best_flap(open_room(20, 5), triangle_cover(20, {10, 10}).lean, {});
  ASSERT_TRUE(flap);
  EXPECT_NEAR(flap->top[0], 5, 1e-12);
  EXPECT_NEAR(flap->top[1], 15, 1e-12);
  EXPECT_EQ(best_flap(open_room(20, 5), triangle_cover(20, {10, 4.2}).lean, {})->height, 4);
  EXPECT_FALSE(best_flap(open_room(20, 5), triangle_cover(20, {10, 2}).lean, {}));
}

TEST(BestFlap, LiesBelowWhatIsInTheWay) {
  RoomProfile profile = open_room(20, 5);
  lower_below(profile, std::vector<Vec2>{{8, 3.2}, {30, 3.2}, {30, 9}, {8, 9}});
  const auto flap = best_flap(profile, triangle_cover(20, {10, 30}).lean, {});
  ASSERT_TRUE(flap);
  EXPECT_EQ(flap->height, 5) << "there is room on the left";
  EXPECT_LT(flap->top[1], 8);
  // The right side goes down steeply enough to pass below the obstacle.
  const double share = 3.2 / 5;
  EXPECT_LE(flap->top[1] + (1 - share) * (flap->foot[1] - flap->top[1]), 8);
}

TEST(BestFlap, NeedsABaseLongEnough) {
  const double base = shortest_base({});
  EXPECT_TRUE(
      best_flap(open_room(base + 0.01, 5), triangle_cover(base + 0.01, {base / 2, 30}).lean, {}));
  EXPECT_FALSE(
      best_flap(open_room(base - 0.1, 5), triangle_cover(base - 0.1, {base / 2, 30}).lean, {}));
}

TEST(LowerBelow, TakesTheLeastOverEachBin) {
  RoomProfile profile = open_room(10, 5);
  lower_below(profile, std::vector<Vec2>{{2, 1}, {4, 3}, {2, 3}});
  for (std::size_t i = 0; i < profile.room.size(); ++i) {
    const double left = i * profile.bin();
    const double right = left + profile.bin();
    for (const double x : {left, right}) {
      if (x < 2 || x > 4) continue;
      EXPECT_LT(profile.room[i], 1 + (x - 2)) << x;
    }
    if (right >= 2 && left <= 4) continue;
    EXPECT_EQ(profile.room[i], 5);
  }
}

TEST(LowerBelow, LeavesRoomAboveWhatLiesBelowTheBase) {
  RoomProfile profile = open_room(10, 5);
  lower_below(profile, std::vector<Vec2>{{0, 0}, {0, -4}, {10, -4}});
  lower_below(profile, std::vector<Vec2>{{-5, 0}, {0, 0}, {-2, 9}});
  for (const double room : profile.room) EXPECT_EQ(room, 5);
}

}  // namespace
}  // namespace foldwright::testing
