#include "repair/weld.h"

#include <gtest/gtest.h>

#include "geometry/random.h"

namespace foldwright {
namespace {

TEST(Weld, MergesCopiesAndNearCopies) {
  const std::vector<Vec3> positions = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1e-7}, {1, 0, 0}};
  EXPECT_EQ(weld(positions, 1e-6), (std::vector<int>{0, 1, 0, 1}));
  EXPECT_EQ(weld(positions, 0), (std::vector<int>{0, 1, 2, 1}));
}

TEST(Weld, DoesNotLetChainsCollapse) {
  std::vector<Vec3> positions;
  for (int i = 0; i < 100; ++i) positions.emplace_back(0.6e-6 * i, 0, 0);
  const std::vector<int> result = weld(positions, 1e-6);
  for (int i = 0; i < 100; ++i) EXPECT_LE((positions[result[i]] - positions[i]).norm(), 1e-6);
  EXPECT_NE(result[99], 0);
}

TEST(Weld, AgreesWithLookingAtAllPairs) {
  Random random(5);
  std::vector<Vec3> positions;
  for (int i = 0; i < 600; ++i) {
    positions.emplace_back(random.uniform() - 0.5, random.uniform() - 0.5, 0);
  }
  const double tolerance = 0.05;
  const std::vector<int> result = weld(positions, tolerance);
  for (int i = 0; i < 600; ++i) {
    int nearest = i;
    double best = tolerance;
    for (int j = 0; j < i; ++j) {
      const double distance = (positions[i] - positions[j]).norm();
      if (result[j] == j && distance < best) {
        best = distance;
        nearest = j;
      }
    }
    EXPECT_EQ(result[i], nearest);
  }
}

}  // namespace
}  // namespace foldwright
