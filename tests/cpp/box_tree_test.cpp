#include "geometry/box_tree.h"

#include <gtest/gtest.h>

#include "geometry/random.h"

namespace foldwright::testing {
namespace {

Vec3 random_point(Random& random) { return {random.uniform(), random.uniform(), random.uniform()}; }

std::vector<Box3> random_boxes(int count, Random& random) {
  std::vector<Box3> boxes;
  for (int i = 0; i < count; ++i) {
    const Vec3 at = random_point(random);
    const Vec3 size = 0.2 * random_point(random);
    boxes.push_back(
        {{at.x(), at.y(), at.z()}, {at.x() + size.x(), at.y() + size.y(), at.z() + size.z()}});
  }
  return boxes;
}

Vec3 centre(const Box3& box) {
  return 0.5 * Vec3(box.min[0] + box.max[0], box.min[1] + box.max[1], box.min[2] + box.max[2]);
}

TEST(BoxTree, FindsTheNearestCentre) {
  const std::uint64_t seed = 1;
  SCOPED_TRACE(seed);
  Random random(seed);
  for (const int count : {1, 2, 5, 100, 1000}) {
    const std::vector<Box3> boxes = random_boxes(count, random);
    const BoxTree tree(boxes);
    for (int query = 0; query < 50; ++query) {
      const Vec3 point = 2 * random_point(random);
      // A centre is no nearer than its box.
      const auto distance = [&](int i) { return (centre(boxes[i]) - point).squaredNorm(); };
      int expected = 0;
      for (int i = 1; i < count; ++i) {
        if (distance(i) < distance(expected)) expected = i;
      }
      int found = 0;
      int visits = 0;
      tree.visit_near(point, distance(0), [&](int i) {
        ++visits;
        if (distance(i) < distance(found)) found = i;
        return distance(found);
      });
      EXPECT_EQ(found, expected);
      EXPECT_LE(visits, count);
    }
  }
}

TEST(BoxTree, VisitsEachItemWithinReachOnce) {
  const std::uint64_t seed = 2;
  SCOPED_TRACE(seed);
  Random random(seed);
  const std::vector<Box3> boxes = random_boxes(500, random);
  std::vector<int> visits(boxes.size(), 0);
  BoxTree(boxes).visit_near(Vec3::Zero(), 100, [&](int i) {
    ++visits[i];
    return 100.0;
  });
  EXPECT_EQ(visits, std::vector<int>(boxes.size(), 1));
}

TEST(BoxTree, OfNothingVisitsNothing) {
  BoxTree({}).visit_near(Vec3::Zero(), 1, [](int) {
    ADD_FAILURE();
    return 1.0;
  });
}

}  // namespace
}  // namespace foldwright::testing
