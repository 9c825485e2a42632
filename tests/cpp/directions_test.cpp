#include "unfold/directions.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "meshes.h"

namespace foldwright::testing {
namespace {

constexpr DirectionSet kAllSets[] = {DirectionSet::kRandom, DirectionSet::kFaceNormals,
                                     DirectionSet::kVertexNormals, DirectionSet::kEdges};

std::vector<std::array<double, 3>> sorted(const std::vector<Vec3>& vectors) {
  std::vector<std::array<double, 3>> result;
  for (const Vec3& v : vectors) result.push_back({v.x(), v.y(), v.z()});
  std::ranges::sort(result);
  return result;
}

TEST(Directions, AreUnitVectors) {
  Random random(1);
  for (const DirectionSet set : kAllSets) {
    const std::vector<Vec3> directions = make_directions(star(), set, 500, random);
    ASSERT_EQ(directions.size(), 500u);
    for (const Vec3& direction : directions) EXPECT_NEAR(direction.norm(), 1, 1e-12);
  }
}

TEST(Directions, RandomOnesPointEverywhere) {
  Random random(2);
  Vec3 sum = Vec3::Zero();
  Vec3 squares = Vec3::Zero();
  for (int i = 0; i < 20000; ++i) {
    const Vec3 direction = random_direction(random);
    sum += direction;
    squares += direction.cwiseAbs2();
  }
  // On a sphere each coordinate has mean 0 and mean square 1/3.
  EXPECT_LT((sum / 20000).cwiseAbs().maxCoeff(), 0.02);
  EXPECT_LT((squares / 20000 - Vec3::Constant(1.0 / 3)).cwiseAbs().maxCoeff(), 0.02);
}

TEST(Directions, OfASurfaceAreTakenOnceBeforeAnyIsRepeated) {
  const Mesh mesh = random_hull(1, 12);  // 20 faces, no two of its edges parallel
  const std::pair<DirectionSet, int> sets[] = {{DirectionSet::kFaceNormals, 20},
                                               {DirectionSet::kVertexNormals, 12},
                                               {DirectionSet::kEdges, 30}};
  for (const auto& [set, size] : sets) {
    SCOPED_TRACE(size);
    Random random(3);
    const std::vector<Vec3> twice = make_directions(mesh, set, 2 * size, random);
    const std::vector<Vec3> first(twice.begin(), twice.begin() + size);
    const std::vector<Vec3> second(twice.begin() + size, twice.end());
    EXPECT_EQ(sorted(first), sorted(second));
    const auto unique = sorted(first);
    EXPECT_EQ(std::ranges::adjacent_find(unique), unique.end());
    EXPECT_NE(first, second) << "the order is to be random";
  }
}

TEST(Directions, OfASurfaceAreItsNormalsAndEdges) {
  const Mesh mesh = cube();
  Random random(4);
  for (const Vec3& normal : make_directions(mesh, DirectionSet::kFaceNormals, 12, random)) {
    EXPECT_NEAR(normal.cwiseAbs().maxCoeff(), 1, 1e-12);
  }
  for (const Vec3& normal :
       make_directions(icosahedron(), DirectionSet::kVertexNormals, 12, random)) {
    double most = -1;
    for (const Vec3& p : icosahedron().positions) most = std::max(most, normal.dot(p));
    EXPECT_NEAR(most, 1, 1e-12);  // straight out at one of the vertices
  }
  for (const Vec3& along : make_directions(mesh, DirectionSet::kEdges, 18, random)) {
    EXPECT_NEAR(std::min({std::abs(along.x()), std::abs(along.y()), std::abs(along.z())}), 0,
                1e-12);
  }
}

TEST(Directions, DoNotDependOnHowManyAreWanted) {
  for (const DirectionSet set : kAllSets) {
    Random one(5);
    Random other(5);
    const std::vector<Vec3> few = make_directions(star(), set, 10, one);
    const std::vector<Vec3> many = make_directions(star(), set, 100, other);
    EXPECT_TRUE(std::equal(few.begin(), few.end(), many.begin()));
  }
}

}  // namespace
}  // namespace foldwright::testing
