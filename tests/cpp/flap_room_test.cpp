#include "paper/flap_room.h"

#include <gtest/gtest.h>

#include "meshes.h"
#include "nets.h"

namespace foldwright::testing {
namespace {

TEST(FlapRoom, ShrinksWithEveryFlap) {
  const std::vector<Net> nets = {net_of(cube(), 80)};
  const Seam seam = find_seams(nets)[0];
  const SeamSide& side = seam.sides[0];
  FlapRoom room(nets, {});
  const Vec2 apex = apex_beyond(side, seam.sides[1]);
  const auto flap = room.best(side, apex, {});
  ASSERT_TRUE(flap);
  EXPECT_EQ(flap->height, 5);
  room.take(side, *flap);
  EXPECT_FALSE(room.best(side, apex, {})) << "its own place is taken";
  EXPECT_EQ(room.why_none(side, apex, {}), FlapMiss::kBlocked);
}

TEST(FlapRoom, IsLimitedByTheFaceBeyond) {
  const std::vector<Net> nets = {net_of(cube(), 80)};
  const SeamSide side = find_seams(nets)[0].sides[0];
  const FlapRoom room(nets, {});
  EXPECT_EQ(room.why_none(side, {20, 1}, {}), FlapMiss::kThin);
  const auto low = room.best(side, {20, 4}, {});
  ASSERT_TRUE(low);
  EXPECT_LT(low->height, 4);
  EXPECT_EQ(room.best(side, open_apex(side), {})->height, 5);
}

TEST(ApexBeyond, IsTheOtherFaceUnfolded) {
  const std::vector<Net> nets = {net_of(cube(), 80)};
  for (const Seam& seam : find_seams(nets)) {
    for (const int s : {0, 1}) {
      const SeamSide& side = seam.sides[s];
      const SeamSide& other = seam.sides[1 - s];
      const Vec2 apex = apex_beyond(side, other);
      // The same triangle, seen from the other side of the edge.
      EXPECT_NEAR((other.third - other.from).norm(), (Vec2(side.length(), 0) - apex).norm(), 1e-9);
      EXPECT_NEAR((other.third - other.to).norm(), apex.norm(), 1e-9);
      EXPECT_GT(apex.y(), 0);
    }
  }
}

}  // namespace
}  // namespace foldwright::testing
