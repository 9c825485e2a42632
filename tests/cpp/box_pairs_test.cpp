#include "geometry/box_pairs.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "geometry/random.h"

namespace foldwright::testing {
namespace {

using Pairs = std::vector<std::array<int, 2>>;

template <int N>
Pairs all_pairs(const std::vector<Box<N>>& boxes) {
  Pairs pairs;
  for (int i = 0; i < static_cast<int>(boxes.size()); ++i) {
    for (int j = i + 1; j < static_cast<int>(boxes.size()); ++j) {
      if (boxes[i].meets(boxes[j])) pairs.push_back({i, j});
    }
  }
  return pairs;
}

template <int N>
void expect_all_pairs(const std::vector<Box<N>>& boxes) {
  Pairs found = meeting_boxes(boxes);
  EXPECT_EQ(meeting_boxes(boxes), found) << "another order the second time";
  std::sort(found.begin(), found.end());
  EXPECT_EQ(found, all_pairs(boxes));
}

template <int N>
std::vector<Box<N>> random_boxes(Random& random, int count, double size) {
  std::vector<Box<N>> boxes(count);
  for (Box<N>& box : boxes) {
    for (int i = 0; i < N; ++i) {
      box.min[i] = random.uniform() - 0.5;
      box.max[i] = box.min[i] + size * random.uniform();
    }
  }
  return boxes;
}

TEST(MeetingBoxes, AreThoseThatLookingAtAllPairsFinds) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const int count = 1 + random.below(300);
    expect_all_pairs(random_boxes<2>(random, count, 0.3 * random.uniform()));
    expect_all_pairs(random_boxes<3>(random, count, 0.6 * random.uniform()));
  }
}

TEST(MeetingBoxes, AreVisitedInTheSameOrderUntilOneIsEnough) {
  Random random(1);
  const std::vector<Box3> boxes = random_boxes<3>(random, 200, 0.3);
  const Pairs all = meeting_boxes(boxes);
  for (const std::size_t enough : {std::size_t{1}, all.size() / 2, all.size() + 1}) {
    Pairs visited;
    visit_meeting_boxes(boxes, [&](int i, int j) {
      visited.push_back({i, j});
      return visited.size() < enough;
    });
    const auto end = all.begin() + static_cast<std::ptrdiff_t>(std::min(enough, all.size()));
    EXPECT_EQ(visited, Pairs(all.begin(), end));
  }
}

TEST(MeetingBoxes, MayDifferMuchInSize) {
  Random random(1);
  std::vector<Box2> boxes = random_boxes<2>(random, 300, 0.02);
  boxes.insert(boxes.begin() + 150, {-100, -100, 100, 100});
  boxes.push_back({-100, 0.1, 100, 0.1001});
  expect_all_pairs(boxes);
  std::vector<Box3> in_space = random_boxes<3>(random, 300, 0.05);
  in_space.insert(in_space.begin() + 150, {-100, -100, -100, 100, 100, 100});
  in_space.push_back({-100, 0.1, -0.2, 100, 0.1001, 0.2});
  expect_all_pairs(in_space);
}

TEST(MeetingBoxes, MayLieFarApart) {
  Random random(2);
  const auto with_far_copies = [](auto boxes) {
    for (int i = 0; i < 50; ++i) {
      auto far = boxes[i];
      far.min.back() += 1e9;
      far.max.back() += 1e9;
      boxes.push_back(far);
    }
    return boxes;
  };
  expect_all_pairs(with_far_copies(random_boxes<2>(random, 50, 0.1)));
  expect_all_pairs(with_far_copies(random_boxes<3>(random, 50, 0.1)));
}

TEST(MeetingBoxes, MayBeCopiesOrPointsOrMissing) {
  expect_all_pairs(std::vector<Box2>(20, {1, 1, 2, 2}));
  expect_all_pairs(std::vector<Box2>(20, {1, 1, 1, 1}));
  expect_all_pairs(std::vector<Box2>{{0, 0, 1, 1}});
  expect_all_pairs(std::vector<Box2>{});
  expect_all_pairs(std::vector<Box3>(20, {1, 1, 1, 2, 2, 2}));
  expect_all_pairs(std::vector<Box3>(20, {1, 1, 1, 1, 1, 1}));
  expect_all_pairs(std::vector<Box3>{{0, 0, 0, 1, 1, 1}});
  expect_all_pairs(std::vector<Box3>{});
}

TEST(MeetingBoxes, MayAllLieInOnePlane) {
  // A net that is still flat.
  Random random(3);
  std::vector<Box3> boxes = random_boxes<3>(random, 200, 0.2);
  for (Box3& box : boxes) box.min[2] = -1e-9, box.max[2] = 1e-9;
  expect_all_pairs(boxes);
}

TEST(MeetingBoxes, MeetWithTheirInsidesOnly) {
  EXPECT_TRUE(meeting_boxes(std::vector<Box2>{{0, 0, 1, 1}, {1, 0, 2, 1}, {0, 1, 1, 2}}).empty());
  EXPECT_TRUE(meeting_boxes(std::vector<Box3>{{0, 0, 0, 1, 1, 1}, {0, 0, 1, 1, 1, 2}}).empty());
}

}  // namespace
}  // namespace foldwright::testing
