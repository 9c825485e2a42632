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
  const FlapRoom::Site site = room.site_of(side, FlapShape{}.height);
  const FlapCover cover = seam.cover_of(0);
  const auto flap = room.best(site, cover, {});
  ASSERT_TRUE(flap);
  EXPECT_EQ(flap->height, 5);
  room.take(side, *flap);
  EXPECT_FALSE(room.best(site, cover, {})) << "its own place is taken";
  EXPECT_EQ(room.why_none(site, cover, {}), FlapMiss::kBlocked);
}

TEST(FlapRoom, IsLimitedByTheFaceBeyond) {
  const std::vector<Net> nets = {net_of(cube(), 80)};
  const SeamSide side = find_seams(nets)[0].sides[0];
  const FlapRoom room(nets, {});
  const FlapRoom::Site site = room.site_of(side, FlapShape{}.height);
  const double length = side.length();
  EXPECT_EQ(room.why_none(site, triangle_cover(length, {20, 1}), {}), FlapMiss::kThin);
  const auto low = room.best(site, triangle_cover(length, {20, 4}), {});
  ASSERT_TRUE(low);
  EXPECT_LT(low->height, 4);
  EXPECT_EQ(room.best(site, {}, {})->height, 5);
}

TEST(FlapRoom, GetsBackWhatAFlapTook) {
  const std::vector<Net> nets = {net_of(cube(), 80)};
  const Seam seam = find_seams(nets)[0];
  FlapRoom room(nets, {});
  const FlapRoom::Site site = room.site_of(seam.sides[0], FlapShape{}.height);
  const auto flap = room.best(site, seam.cover_of(0), {});
  ASSERT_TRUE(flap);
  room.give_back(seam.sides[0], room.take(seam.sides[0], *flap));
  EXPECT_EQ(room.best(site, seam.cover_of(0), {})->top[1], flap->top[1]);
}

}  // namespace
}  // namespace foldwright::testing
