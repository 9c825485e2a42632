#include "paper/callouts.h"

#include <gtest/gtest.h>

#include "meshes.h"
#include "nets.h"

namespace foldwright::testing {
namespace {

TEST(CalloutFinder, LeadsToTheMiddleOfTheEdge) {
  const std::vector<Net> nets = {net_of(cube(), 80)};
  LabelSpace space(nets[0], {});
  CalloutFinder finder(nets[0], 1.4, 0.25);
  const SeamSide side = find_seams(nets)[0].sides[0];
  const auto found = finder.find(space, side, "123", std::array{1.7, 1.4});
  ASSERT_TRUE(found);
  const Vec2 middle = 0.5 * (side.from + side.to);
  EXPECT_LT((found->leader.to - middle).norm(), 0.3);
  EXPECT_TRUE(space.is_free(found->box));
  EXPECT_LT((found->box.centre - middle).norm(), 4) << "near by";
  EXPECT_LT(side.local(found->box.centre).y(), 0) << "on the face";
}

TEST(CalloutFinder, GivesUpWithoutRoom) {
  const std::vector<Net> nets = {net_of(cube(), 3)};
  const LabelSpace space(nets[0], {});
  CalloutFinder finder(nets[0], 1.4, 0.25);
  for (const Seam& seam : find_seams(nets)) {
    EXPECT_FALSE(finder.find(space, seam.sides[0], "123", std::array{1.4}));
  }
}

}  // namespace
}  // namespace foldwright::testing
