#include "paper/text_box.h"

#include <gtest/gtest.h>

#include <cmath>

#include "geometry/random.h"

namespace foldwright::testing {
namespace {

TEST(TextWidth, GrowsWithTheText) {
  EXPECT_NEAR(text_width("17"), 2 * text_width("7"), 1e-12);
  EXPECT_LT(text_width("1:"), text_width("11"));
  EXPECT_LT(text_width("A"), text_width("W"));
  // A character of three bytes is as wide as high.
  EXPECT_NEAR(text_width("\xe7\xbf\xbc"), 1.05, 1e-12);
}

TEST(BoxAround, LeavesRoomForWhatHangsBelowTheBaseline) {
  const TextBox plain = box_around("A1", {2, 0.3}, {0, 0}, {1, 0});
  const TextBox tall = box_around("gy", {2, 0.3}, {0, 0}, {1, 0});
  EXPECT_NEAR(plain.half_height, 0.5 * kCapHeight * 2 + 0.3, 1e-12);
  EXPECT_GT(tall.half_height, plain.half_height);
}

TEST(Meets, AgreesWithPointsAlongTheStroke) {
  Random random(7);
  for (int trial = 0; trial < 2000; ++trial) {
    const double angle = 6 * random.uniform();
    const TextBox box = {{random.uniform(), random.uniform()},
                         {std::cos(angle), std::sin(angle)},
                         0.1 + 0.3 * random.uniform(),
                         0.1 + 0.3 * random.uniform()};
    const Stroke stroke = {{2 * random.uniform() - 0.5, 2 * random.uniform() - 0.5},
                           {2 * random.uniform() - 0.5, 2 * random.uniform() - 0.5}};
    bool inside = false;
    for (int i = 0; i <= 200; ++i) {
      const Vec2 p = stroke.from + i / 200.0 * (stroke.to - stroke.from) - box.centre;
      inside = inside || (std::abs(p.dot(box.along)) < box.half_width &&
                          std::abs(p.dot(box.up())) < box.half_height);
    }
    // Points may miss a corner that is cut off, but never find more.
    if (inside) {
      EXPECT_TRUE(meets(box, stroke)) << trial;
    }
  }
}

TEST(Crosses, SeesStrokesThroughEachOther) {
  EXPECT_TRUE(crosses({{0, 0}, {2, 2}}, {{0, 2}, {2, 0}}));
  EXPECT_FALSE(crosses({{0, 0}, {1, 1}}, {{0, 3}, {3, 0}}));
  EXPECT_TRUE(crosses({{0, 0}, {1, 1}}, {{0, 2}, {2, 0}})) << "touching counts";
}

}  // namespace
}  // namespace foldwright::testing
