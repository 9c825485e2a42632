#include "geometry/triangle3.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "folding.h"
#include "geometry/random.h"

namespace foldwright::testing {
namespace {

constexpr double kTolerance = 1e-10;

bool meet(const Triangle3& a, const Triangle3& b) { return triangles_meet(a, b, kTolerance); }

Vec3 random_point(Random& random) {
  const double x = random.uniform();
  const double y = random.uniform();
  return {x, y, random.uniform()};
}

Triangle3 random_triangle(Random& random) {
  const Vec3 a = random_point(random);
  const Vec3 b = random_point(random);
  return {a, b, random_point(random)};
}

RigidMotion3 random_motion(Random& random) {
  const Eigen::Quaterniond r(random.normal(), random.normal(), random.normal(), random.normal());
  return {r.normalized(), random_point(random)};
}

Triangle3 scaled(const Triangle3& t, double factor) {
  return {factor * t[0], factor * t[1], factor * t[2]};
}

/// Least of distances between points of the one and the other, on a grid.
double distance_on_grid(const Triangle3& a, const Triangle3& b) {
  static constexpr int kSteps = 12;
  const auto points = [](const Triangle3& t) {
    std::vector<Vec3> on;
    for (int i = 0; i <= kSteps; ++i) {
      for (int k = 0; i + k <= kSteps; ++k) {
        on.push_back((i * t[0] + k * t[1] + (kSteps - i - k) * t[2]) / kSteps);
      }
    }
    return on;
  };
  double least = std::numeric_limits<double>::infinity();
  for (const Vec3& p : points(a)) {
    for (const Vec3& q : points(b)) least = std::min(least, (p - q).norm());
  }
  return least;
}

TEST(Triangles3, MeetExactlyWhenAnEdgeOfOnePassesThroughTheOther) {
  Random random(1);
  int meeting = 0;
  for (int i = 0; i < 50000; ++i) {
    SCOPED_TRACE(i);
    const Triangle3 a = random_triangle(random);
    const Triangle3 b = random_triangle(random);
    const bool together = meet(a, b);
    EXPECT_EQ(together, meet_by_edges(a, b));
    EXPECT_EQ(together, meet(b, a));
    meeting += together ? 1 : 0;
  }
  EXPECT_GT(meeting, 5000);
  EXPECT_LT(meeting, 45000);
}

TEST(Triangles3, MeetAlikeAtEveryScaleAndPlace) {
  Random random(2);
  for (int i = 0; i < 5000; ++i) {
    SCOPED_TRACE(i);
    const Triangle3 a = random_triangle(random);
    const Triangle3 b = random_triangle(random);
    const bool together = meet(a, b);
    const RigidMotion3 motion = random_motion(random);
    EXPECT_EQ(meet(moved(motion, a), moved(motion, b)), together);
    for (const double factor : {0x1p-60, 0x1p60}) {
      EXPECT_EQ(triangles_meet(scaled(a, factor), scaled(b, factor), factor * kTolerance),
                together);
    }
  }
}

TEST(Triangles3, InOnePlaneMeetWhenTheyOverlap) {
  Random random(3);
  int meeting = 0;
  for (int i = 0; i < 5000; ++i) {
    SCOPED_TRACE(i);
    Triangle2 a, b;
    do {
      for (Triangle2* t : {&a, &b}) {
        for (Vec2& p : *t) p = random_point(random).head<2>();
        if (cross((*t)[1] - (*t)[0], (*t)[2] - (*t)[0]) < 0) std::swap((*t)[1], (*t)[2]);
      }
      // Close to touching, rounding decides.
    } while (triangles_overlap(a, b, 0) != triangles_overlap(a, b, 1e-8));
    const RigidMotion3 motion = random_motion(random);
    const bool overlap = triangles_overlap(a, b, 0);
    EXPECT_EQ(meet(moved(motion, a), moved(motion, b)), overlap);
    meeting += overlap ? 1 : 0;
  }
  EXPECT_GT(meeting, 500);
  EXPECT_LT(meeting, 4500);
}

TEST(Triangles3, ThatTouchMeet) {
  const Triangle3 a = {Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0)};
  const auto at = [](double x, double y, double z) {
    return Triangle3{Vec3(x, y, z), Vec3(x + 1, y, z + 1), Vec3(x, y + 1, z + 1)};
  };
  EXPECT_TRUE(meet(a, at(1, 1, 0))) << "a corner on the face";
  EXPECT_TRUE(meet(a, at(2, 2, 0))) << "a corner on an edge";
  EXPECT_TRUE(meet(a, at(4, 0, 0))) << "corner on corner";
  EXPECT_TRUE(meet(a, at(1, 1, -1e-9)));
  EXPECT_FALSE(meet(a, at(1, 1, 1e-9)));
  EXPECT_FALSE(meet(a, at(2 + 1e-9, 2, 0)));
  EXPECT_TRUE(meet(a, a));
  const Triangle3 across_edge = {Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 0, 4)};
  EXPECT_TRUE(meet(a, across_edge));
}

TEST(Triangles3, MeetWhenNearerThanTheTolerance) {
  const Triangle3 a = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  const RigidMotion3 up{Eigen::Quaterniond::Identity(), Vec3(0, 0, 1e-3)};
  const RigidMotion3 aside{Eigen::Quaterniond::Identity(), Vec3(1.001, 0, 0)};
  for (const RigidMotion3& way : {up, aside}) {
    EXPECT_FALSE(triangles_meet(a, moved(way, a), 0));
    EXPECT_FALSE(triangles_meet(a, moved(way, a), 0.9e-3 * (way.t.z() > 0 ? 1 : 0.5)));
    EXPECT_TRUE(triangles_meet(a, moved(way, a), 1.1e-3));
  }
}

TEST(Triangles3, BesideEachOtherDoNotMeet) {
  // In parallel planes, in one plane, and with boxes that meet.
  const Triangle3 a = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  const Triangle3 above = {Vec3(0, 0, 1e-8), Vec3(1, 0, 1e-8), Vec3(0, 1, 1e-8)};
  const Triangle3 opposite = {Vec3(1, 1, 0), Vec3(1e-8, 1, 0), Vec3(1, 1e-8, 0)};
  EXPECT_FALSE(meet(a, above));
  EXPECT_FALSE(meet(a, opposite));
  // Two edges pass each other crosswise: only the cross product of both tells them apart.
  const Triangle3 ridge = {Vec3(-1, 0, 0), Vec3(1, 0, 0), Vec3(0, 0, -5)};
  const Triangle3 roof = {Vec3(0, -1, 1e-3), Vec3(0, 1, 1e-3), Vec3(0, 0, 5)};
  EXPECT_FALSE(meet(ridge, roof));
  EXPECT_TRUE(meet(ridge, moved(RigidMotion3{{1, 0, 0, 0}, Vec3(0, 0, -2e-3)}, roof)));
}

TEST(Triangles3, FarApartDoNotMeet) {
  Random random(4);
  for (int i = 0; i < 1000; ++i) {
    SCOPED_TRACE(i);
    const Triangle3 a = random_triangle(random);
    const Vec3 way = 2 * (random_point(random) - Vec3::Constant(0.5)).normalized();
    const Triangle3 b = moved({Eigen::Quaterniond::Identity(), way}, random_triangle(random));
    if (distance_on_grid(a, b) > 0.5) {
      EXPECT_FALSE(meet(a, b));
    }
    const Triangle3 farther = moved({Eigen::Quaterniond::Identity(), 1e9 * way}, b);
    EXPECT_FALSE(meet(a, farther));
  }
}

TEST(Triangles3, MayBeSlivers) {
  const Triangle3 floor = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  const auto needle = [](double from, double to) {
    return Triangle3{Vec3(0.3, 0.3, from), Vec3(0.3, 0.3, to), Vec3(0.3 + 1e-9, 0.3, from)};
  };
  EXPECT_TRUE(meet(floor, needle(-1, 1)));
  EXPECT_FALSE(meet(floor, needle(1e-6, 1)));
}

/// The line between centroids, two normals, six in the planes, nine across edges.
constexpr int kAxes = 18;

TEST(SeparatingAxes, TellDisjointTrianglesApart) {
  // Every direction that is visited has both projections right: one with a gap is a proof.
  Random random(5);
  int apart = 0;
  for (int i = 0; i < 2000; ++i) {
    const Triangle3 a = random_triangle(random);
    const Triangle3 b = random_triangle(random);
    int visits = 0;
    bool separated = false;
    for_separating_axes(a, b, [&](const Vec3& axis) {
      ++visits;
      const auto along = [&](const Vec3& p) { return axis.dot(p); };
      const auto [low_a, high_a] = std::minmax({along(a[0]), along(a[1]), along(a[2])});
      const auto [low_b, high_b] = std::minmax({along(b[0]), along(b[1]), along(b[2])});
      return separated = low_a > high_b || low_b > high_a;
    });
    EXPECT_EQ(separated, !meet_by_edges(a, b));
    EXPECT_LE(visits, kAxes);
    apart += separated ? 1 : 0;
  }
  EXPECT_GT(apart, 200);
}

TEST(SeparatingAxes, StopWhenToldTo) {
  Random random(6);
  const Triangle3 a = random_triangle(random);
  for (int most = 1; most <= kAxes; ++most) {
    int visits = 0;
    for_separating_axes(a, random_triangle(random), [&](const Vec3&) { return ++visits == most; });
    EXPECT_EQ(visits, most);
  }
}

TEST(Eroded, HasEachSideMovedInwards) {
  Random random(7);
  for (int i = 0; i < 1000; ++i) {
    SCOPED_TRACE(i);
    Triangle2 t;
    for (Vec2& p : t) p = random_point(random).head<2>();
    if (cross(t[1] - t[0], t[2] - t[0]) < 0) std::swap(t[1], t[2]);
    const double depth = 0.02 * random.uniform();
    const Triangle2 small = eroded(t, depth, 0.8);
    const Triangle3 by_corners = eroded_by_corners(moved(RigidMotion3{}, t), depth);
    double least = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 3; ++k) {
      EXPECT_LT((small[k] - by_corners[k].head<2>()).norm(), 1e-9);
      const Vec2 edge = t[(k + 1) % 3] - t[k];
      least = std::min(least, cross(edge, small[k] - t[k]) / edge.norm());
    }
    EXPECT_GE(least, 0);
    EXPECT_LE(least, depth + 1e-12);
  }
}

TEST(Eroded, KeepsMostOfASliver) {
  const Triangle2 sliver = {Vec2(0, 0), Vec2(10, 0), Vec2(5, 1e-3)};
  const Triangle2 small = eroded(sliver, 0.1, 0.8);
  EXPECT_NEAR((small[1] - small[0]).norm(), 8, 1e-9);
  const Triangle2 same = eroded(sliver, 0, 0.8);
  for (int i = 0; i < 3; ++i) EXPECT_LT((same[i] - sliver[i]).norm(), 1e-12);
}

TEST(ClosestPoint, IsNearerThanAnyOtherPoint) {
  Random random(9);
  for (int i = 0; i < 300; ++i) {
    const Triangle3 t = random_triangle(random);
    const Vec3 p = 2 * random_point(random) - Vec3(0.5, 0.5, 0.5);
    const Vec3 closest = closest_point(t, p);
    EXPECT_LT((closest_point(t, closest) - closest).norm(), 1e-12) << "it is a point of it";
    const double on_grid = distance_on_grid(t, {p, p, p});
    EXPECT_LE((closest - p).norm(), on_grid + 1e-12);
    EXPECT_GT((closest - p).norm(), on_grid - 0.15) << "the grid is that fine";
  }
}

TEST(ClosestPoint, IsOnTheSegmentOrPointThatATriangleHasShrunkTo) {
  const Vec3 a(0, 0, 0), b(2, 0, 0), p(1, 1, 0);
  EXPECT_EQ(closest_point({a, b, a}, p), Vec3(1, 0, 0));
  EXPECT_EQ(closest_point({b, b, b}, p), b);
}

TEST(Barycentric, SharesAddUpToThePoint) {
  Random random(10);
  for (int i = 0; i < 300; ++i) {
    const Triangle3 t = random_triangle(random);
    const Vec3 p = closest_point(t, 2 * random_point(random) - Vec3(0.5, 0.5, 0.5));
    const Vec3 shares = barycentric(t, p);
    EXPECT_NEAR(shares.sum(), 1, 1e-12);
    EXPECT_GE(shares.minCoeff(), -1e-9);
    EXPECT_LT((shares[0] * t[0] + shares[1] * t[1] + shares[2] * t[2] - p).norm(), 1e-9);
  }
}

TEST(Barycentric, ShareOfACornerIsTheWhole) {
  const Triangle3 t = {Vec3(1, 2, 3), Vec3(4, 0, 1), Vec3(-1, 5, 2)};
  for (int i = 0; i < 3; ++i) {
    EXPECT_LT((barycentric(t, t[i]) - Vec3::Unit(i)).norm(), 1e-15);
  }
}

TEST(Moved, PutsATriangleOfThePlaneInSpace) {
  Random random(8);
  for (int i = 0; i < 100; ++i) {
    const Triangle2 flat = {random_point(random).head<2>(), random_point(random).head<2>(),
                            random_point(random).head<2>()};
    const RigidMotion3 motion = random_motion(random);
    const Triangle3 lifted = moved(RigidMotion3{}, flat);
    const Triangle3 placed = moved(motion, flat);
    const Triangle3 placed_too = moved(motion, lifted);
    for (int k = 0; k < 3; ++k) {
      EXPECT_EQ(lifted[k], Vec3(flat[k].x(), flat[k].y(), 0));
      EXPECT_LT((placed[k] - motion(lifted[k])).norm(), 1e-14);
      EXPECT_LT((placed_too[k] - motion(lifted[k])).norm(), 1e-14);
    }
  }
}

TEST(Box3, EnclosesATriangle) {
  const Box3 box = box_of(Triangle3{Vec3(1, 2, -3), Vec3(4, 0, 7), Vec3(3, 5, 0)});
  EXPECT_EQ(box.min, (std::array<double, 3>{1, 0, -3}));
  EXPECT_EQ(box.max, (std::array<double, 3>{4, 5, 7}));
  EXPECT_DOUBLE_EQ(box.diagonal(), std::sqrt(9.0 + 25 + 100));
  EXPECT_TRUE(box.meets({3.9, 4.9, 6.9, 9, 9, 9}));
  EXPECT_FALSE(box.meets({3.9, 4.9, 7, 9, 9, 9}));
  EXPECT_TRUE(box.grown(0.1).meets({3.9, 4.9, 7, 9, 9, 9}));
  const Box3 both = box.joined({-1, 1, 8, 0, 2, 9});
  EXPECT_EQ(both.min, (std::array<double, 3>{-1, 0, -3}));
  EXPECT_EQ(both.max, (std::array<double, 3>{4, 5, 9}));
}

}  // namespace
}  // namespace foldwright::testing
