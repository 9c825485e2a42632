#include "geometry/random.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>

namespace foldwright::testing {
namespace {

TEST(Random, GivesThePublishedNumbers) {
  // xoshiro256** after splitmix64, computed from the authors' definitions.
  EXPECT_EQ(Random(0).bits(), 0x99ec5f36cb75f2b4);
  Random random(1);
  EXPECT_EQ(random.bits(), 0xb3f2af6d0fc710c5);
  EXPECT_EQ(random.bits(), 0x853b559647364cea);
  EXPECT_EQ(random.bits(), 0x92f89756082a4514);
}

TEST(Random, DrawsWholeNumbersEvenly) {
  Random random(2);
  std::array<int, 10> counts{};
  for (int i = 0; i < 100000; ++i) ++counts.at(random.below(10));
  for (const int count : counts) EXPECT_NEAR(count, 10000, 5 * std::sqrt(9000));  // five sigma
  EXPECT_EQ(random.below(1), 0);
}

TEST(Random, DrawsRealsEvenlyFromTheHalfOpenUnitInterval) {
  Random random(3);
  double sum = 0;
  double squares = 0;
  for (int i = 0; i < 100000; ++i) {
    const double x = random.uniform();
    ASSERT_GE(x, 0);
    ASSERT_LT(x, 1);
    sum += x;
    squares += x * x;
  }
  EXPECT_NEAR(sum / 100000, 1.0 / 2, 0.005);
  EXPECT_NEAR(squares / 100000, 1.0 / 3, 0.005);
}

TEST(Random, DrawsNormalNumbers) {
  Random random(4);
  double sum = 0;
  double squares = 0;
  int within_one = 0;
  for (int i = 0; i < 100000; ++i) {
    const double x = random.normal();
    sum += x;
    squares += x * x;
    within_one += std::abs(x) < 1;
  }
  EXPECT_NEAR(sum / 100000, 0, 0.02);
  EXPECT_NEAR(squares / 100000, 1, 0.03);
  EXPECT_NEAR(within_one / 100000.0, 0.6827, 0.01);
}

TEST(TaskSeed, IsPinned) {
  EXPECT_EQ(task_seed(1, SeedTag::kClustering, 3, 4), 0xd55ccd4aeb3ccafb);
}

TEST(TaskSeed, TellsAllTasksApart) {
  std::set<std::uint64_t> seeds;
  int count = 0;
  for (const std::uint64_t seed : {0ull, 1ull, 1ull << 32}) {
    for (std::uint64_t stage = 0; stage < 5; ++stage) {
      for (std::uint64_t part = 0; part < 30; ++part) {
        for (std::uint64_t index = 0; index < 100; ++index, ++count) {
          seeds.insert(task_seed(seed, static_cast<SeedTag>(stage), part, index));
        }
      }
    }
  }
  EXPECT_EQ(static_cast<int>(seeds.size()), count);
}

}  // namespace
}  // namespace foldwright::testing
