#include "geometry/box_pairs.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "geometry/random.h"

namespace foldwright::testing {
namespace {

using Pairs = std::vector<std::array<int, 2>>;

Pairs all_pairs(const std::vector<Box2>& boxes) {
  Pairs pairs;
  for (int i = 0; i < static_cast<int>(boxes.size()); ++i) {
    for (int j = i + 1; j < static_cast<int>(boxes.size()); ++j) {
      if (boxes[i].meets(boxes[j])) pairs.push_back({i, j});
    }
  }
  return pairs;
}

void expect_all_pairs(const std::vector<Box2>& boxes) {
  Pairs found = meeting_boxes(boxes);
  EXPECT_EQ(meeting_boxes(boxes), found) << "another order the second time";
  std::sort(found.begin(), found.end());
  EXPECT_EQ(found, all_pairs(boxes));
}

std::vector<Box2> random_boxes(Random& random, int count, double size) {
  std::vector<Box2> boxes;
  for (int i = 0; i < count; ++i) {
    const double x = random.uniform() - 0.5;
    const double y = random.uniform() - 0.5;
    boxes.push_back({x, y, x + size * random.uniform(), y + size * random.uniform()});
  }
  return boxes;
}

TEST(MeetingBoxes, AreThoseThatLookingAtAllPairsFinds) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    expect_all_pairs(random_boxes(random, 1 + random.below(300), 0.3 * random.uniform()));
  }
}

TEST(MeetingBoxes, MayDifferMuchInSize) {
  Random random(1);
  std::vector<Box2> boxes = random_boxes(random, 300, 0.02);
  boxes.insert(boxes.begin() + 150, {-100, -100, 100, 100});
  boxes.push_back({-100, 0.1, 100, 0.1001});
  expect_all_pairs(boxes);
}

TEST(MeetingBoxes, MayLieFarApart) {
  Random random(2);
  std::vector<Box2> boxes = random_boxes(random, 50, 0.1);
  for (int i = 0; i < 50; ++i) {
    Box2 far = boxes[i];
    far.min[0] += 1e9;
    far.max[0] += 1e9;
    boxes.push_back(far);
  }
  expect_all_pairs(boxes);
}

TEST(MeetingBoxes, MayBeCopiesOrPointsOrMissing) {
  expect_all_pairs(std::vector<Box2>(20, {1, 1, 2, 2}));
  expect_all_pairs(std::vector<Box2>(20, {1, 1, 1, 1}));
  expect_all_pairs({{0, 0, 1, 1}});
  expect_all_pairs({});
}

TEST(MeetingBoxes, MeetWithTheirInsidesOnly) {
  EXPECT_TRUE(meeting_boxes(std::vector<Box2>{{0, 0, 1, 1}, {1, 0, 2, 1}, {0, 1, 1, 2}}).empty());
}

}  // namespace
}  // namespace foldwright::testing
