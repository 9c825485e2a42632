#include "simplify/crossing_guard.h"

#include <gtest/gtest.h>

namespace foldwright::testing {
namespace {

const Triangle3 kLying = {Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(0, 2, 0)};
const Triangle3 kStanding = {Vec3(0.5, 0.5, -1), Vec3(0.5, 0.5, 1), Vec3(0.5, 2, 0)};

CrossingGuard guard_of_lying() {
  CrossingGuard guard(2, 1, 4);
  guard.set(0, {0, 1, 2}, kLying);
  return guard;
}

TEST(CrossingGuard, CountsFacesThatAreRunThrough) {
  CrossingGuard guard = guard_of_lying();
  EXPECT_EQ(guard.crossings({3, 4, 5}, kStanding, {}), 1);
  Triangle3 above = kStanding;
  for (Vec3& p : above) p.z() += 3;
  EXPECT_EQ(guard.crossings({3, 4, 5}, above, {}), 0);
}

TEST(CrossingGuard, LeavesNeighboursAndOthersOut) {
  CrossingGuard guard = guard_of_lying();
  EXPECT_EQ(guard.crossings({1, 2, 5}, kStanding, {}), 0);
  EXPECT_EQ(guard.crossings({1, 4, 5}, kStanding, {}), 1);
  EXPECT_EQ(guard.crossings({3, 4, 5}, kStanding, std::vector{0}), 0);
}

TEST(CrossingGuard, HoldsFacesAsTheyAreNow) {
  CrossingGuard guard = guard_of_lying();
  Triangle3 away = kLying;
  for (Vec3& p : away) p.x() += 9;
  guard.set(0, {0, 1, 2}, away);
  EXPECT_EQ(guard.crossings({3, 4, 5}, kStanding, {}), 0);
  guard.set(0, {0, 1, 2}, kLying);
  EXPECT_EQ(guard.crossings({3, 4, 5}, kStanding, {}), 1);
  guard.remove(0);
  EXPECT_EQ(guard.crossings({3, 4, 5}, kStanding, {}), 0);
}

}  // namespace
}  // namespace foldwright::testing
