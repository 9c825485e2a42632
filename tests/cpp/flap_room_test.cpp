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
  const FlapCover cover = seam.cover_of(0);
  const auto flap = room.best(side, cover, {});
  ASSERT_TRUE(flap);
  EXPECT_EQ(flap->height, 5);
  room.take(side, *flap);
  EXPECT_FALSE(room.best(side, cover, {})) << "its own place is taken";
  EXPECT_EQ(room.why_none(side, cover, {}), FlapMiss::kBlocked);
}

TEST(FlapRoom, IsLimitedByTheFaceBeyond) {
  const std::vector<Net> nets = {net_of(cube(), 80)};
  const SeamSide side = find_seams(nets)[0].sides[0];
  const FlapRoom room(nets, {});
  const double length = side.length();
  EXPECT_EQ(room.why_none(side, triangle_cover(length, {20, 1}), {}), FlapMiss::kThin);
  const auto low = room.best(side, triangle_cover(length, {20, 4}), {});
  ASSERT_TRUE(low);
  EXPECT_LT(low->height, 4);
  EXPECT_EQ(room.best(side, {}, {})->height, 5);
}

TEST(FlapRoom, GetsBackWhatAFlapTook) {
  const std::vector<Net> nets = {net_of(cube(), 80)};
  const Seam seam = find_seams(nets)[0];
  FlapRoom room(nets, {});
  const auto flap = room.best(seam.sides[0], seam.cover_of(0), {});
  ASSERT_TRUE(flap);
  room.give_back(seam.sides[0], room.take(seam.sides[0], *flap));
  EXPECT_EQ(room.best(seam.sides[0], seam.cover_of(0), {})->top[1], flap->top[1]);
}

}  // namespace
}  // namespace foldwright::testing
