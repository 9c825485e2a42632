#include "repair/flatten_planes.h"

#include <gtest/gtest.h>

#include "geometry/random.h"
#include "repair/planar_fit.h"

namespace foldwright {
namespace {

/// A sheet of n x n squares in two triangles each, folded along the middle, jittered by `error`.
TriangleSoup folded_sheet(int n, double error) {
  TriangleSoup soup;
  Random random(3);
  const auto jitter = [&] { return error * (2 * random.uniform() - 1); };
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j <= n; ++j) {
      const Vec3 drawn(i, j, std::abs(i - n / 2));
      soup.positions.push_back(drawn + Vec3(jitter(), jitter(), jitter()));
    }
  }
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const int a = i * (n + 1) + j;
      const int b = a + n + 1;
      soup.faces.insert(soup.faces.end(), {{a, b, b + 1}, {a, b + 1, a + 1}});
      soup.source_faces.insert(soup.source_faces.end(), {2 * (i * n + j), 2 * (i * n + j) + 1});
    }
  }
  soup.errors.assign(soup.positions.size(), error);
  return soup;
}

TEST(FlattenPlanes, PutsVerticesInTheirPlanesNearby) {
  TriangleSoup soup = folded_sheet(6, 1e-3);
  const std::vector<Vec3> before = soup.positions;
  const DrawnPlanes planes = find_drawn_planes(soup);
  ASSERT_EQ(planes.size(), 2u);
  const Flattening flattening = flatten_planes(soup, planes);
  EXPECT_EQ(flattening.faces.size(), soup.faces.size());
  for (const std::vector<int>& plane : planes) {
    EXPECT_EQ(plane.size(), 36u);
    EXPECT_LT(fit_plane(soup, plane).deviation, 1e-9);
  }
  double furthest = 0;
  for (std::size_t v = 0; v < before.size(); ++v) {
    furthest = std::max(furthest, (soup.positions[v] - before[v]).norm());
  }
  EXPECT_EQ(flattening.distance, furthest);
  EXPECT_LT(furthest, 3e-3);
}

TEST(FlattenPlanes, LeavesExactPlanesAlone) {
  TriangleSoup soup = folded_sheet(4, 0);
  const std::vector<Vec3> before = soup.positions;
  const Flattening flattening = flatten_planes(soup, find_drawn_planes(soup));
  EXPECT_TRUE(flattening.faces.empty());
  EXPECT_EQ(flattening.distance, 0);
  EXPECT_EQ(soup.positions, before);
}

TEST(FlattenPlanes, GivesUpPlanesThatContradictExactOnes) {
  // Five corners in a plane and a quad of which three corners are in it, far off with the fourth,
  // which is held by another exact plane.
  TriangleSoup soup{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0.5}, {2, 1, 0}},
                    {{0, 1, 2}, {0, 2, 3}, {1, 4, 2}, {4, 5, 2}},
                    {0, 0, 1, 1},
                    {}};
  const std::vector<Vec3> before = soup.positions;
  flatten_planes(soup, {{0, 1}, {0, 1, 2, 3}});
  for (std::size_t v = 0; v < 4; ++v) EXPECT_LT((soup.positions[v] - before[v]).norm(), 1.0);
  EXPECT_LT(fit_plane(soup, std::vector<int>{0, 1}).deviation, 1e-9);
}

}  // namespace
}  // namespace foldwright
