#include "geometry/union_find.h"

#include <gtest/gtest.h>

namespace foldwright {
namespace {

TEST(UnionFind, TheLowestMemberStandsForASet) {
  UnionFind sets(6);
  EXPECT_TRUE(sets.join(5, 3));
  EXPECT_TRUE(sets.join(4, 5));
  EXPECT_EQ(sets.find(4), 3);
  EXPECT_EQ(sets.find(2), 2);
}

TEST(UnionFind, TellsWhetherAJoinChangedAnything) {
  UnionFind sets(4);
  EXPECT_TRUE(sets.join(0, 1));
  EXPECT_TRUE(sets.join(2, 3));
  EXPECT_TRUE(sets.join(1, 3));
  EXPECT_FALSE(sets.join(0, 2));
}

}  // namespace
}  // namespace foldwright
