#include "paper/flap_gaps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "meshes.h"
#include "nets.h"
#include "outline_gaps.h"

namespace foldwright::testing {
namespace {

using Polygon = std::vector<Vec2>;

/// An edge along x from the origin, with its paper above.
SeamSide edge_of(double length) {
  return {.net = 0,
          .edges = {0},
          .faces = {0},
          .base = {0, 1},
          .from = {0, 0},
          .to = {length, 0},
          .panel = {}};
}

/// A face whose edge to the origin leaves a wedge of some degrees below that edge.
Polygon face_beyond(double degrees) {
  const double angle = degrees * std::numbers::pi / 180;
  return {20 * Vec2(std::cos(angle), -std::sin(angle)), {0, 0}, {-9, -9}};
}

double inset(double height, double degrees) {
  return height / std::tan(degrees * std::numbers::pi / 180);
}

TEST(FlapGaps, ASideGoesOntoTheLineBesideIt) {
  const Polygon face = face_beyond(50);
  const Trapezoid flap = {4, {0, 20}, {inset(4, 50) + 0.1, 17}};
  const auto laid = laid_on(edge_of(20), flap, 0, {{face}, {}});
  ASSERT_TRUE(laid);
  EXPECT_NEAR(laid->top[0], inset(4, 50), 1e-12);
  EXPECT_NEAR(laid->foot[0], 0, 1e-12);
  EXPECT_EQ(laid->top[1], 17) << "the other end stays";
  EXPECT_FALSE(laid_on(edge_of(20), flap, 1, {{face}, {}}));
}

TEST(FlapGaps, ASideStaysWhereNoLineIsNear) {
  const Polygon face = face_beyond(50);
  EXPECT_FALSE(laid_on(edge_of(20), {4, {0, 20}, {inset(4, 50) + 0.5, 17}}, 0, {{face}, {}}));
  EXPECT_FALSE(laid_on(edge_of(20), {4, {0, 20}, {2, 17}}, 0, {}));
}

TEST(FlapGaps, SidesThatGoOntoLinesDoNotCross) {
  const Polygon face = face_beyond(50);
  const Trapezoid narrow = {4, {0, 8}, {inset(4, 50) - 0.2, inset(4, 50) + 0.1}};
  EXPECT_FALSE(laid_on(edge_of(8), narrow, 0, {{face}, {}}));
}

TEST(FlapGaps, ASideIsDrawnInFromACutBesideIt) {
  const Polygon face = face_beyond(50);
  const Trapezoid flap = {4, {0, 20}, {inset(4, 50) + 0.6, 17}};
  const Trapezoid own = drawn_in(edge_of(20), flap, 0, {{face}, {}});
  EXPECT_EQ(own.height, 4);
  EXPECT_EQ(own.top[1], 17);
  EXPECT_GT(own.foot[0], 0.3);
  EXPECT_NEAR(own.top[0] - own.foot[0], flap.top[0], 1e-12) << "its slope stays";
  // A flap in the way leaves the other half of the room itself.
  EXPECT_LT(drawn_in(edge_of(20), flap, 0, {{}, {face}}).foot[0], own.foot[0]);
}

TEST(FlapGaps, AFlapWithRoomStaysAsItIs) {
  const Trapezoid flap = {4, {0, 20}, {3, 17}};
  const Polygon far = face_beyond(120);
  for (const int end : {0, 1}) {
    const Trapezoid own = drawn_in(edge_of(20), flap, end, {{far}, {}});
    EXPECT_EQ(own.foot[end], flap.foot[end]);
    EXPECT_EQ(own.top[end], flap.top[end]);
  }
}

TEST(FlapGaps, NarrowFlapsKeepTheirTops) {
  const Polygon face = face_beyond(50);
  const Trapezoid flap = {4, {0, 8}, {inset(4, 50) + 0.6, 4.5}};
  EXPECT_EQ(drawn_in(edge_of(8), flap, 0, {{face}, {}}).foot[0], 0);
}

TEST(FlapGaps, AnIcosahedronIsCutAlongLinesOrWithRoom) {
  const Mesh mesh = icosahedron();
  const std::vector<Net> nets = {net_of(mesh, 60)};
  const FlapPlan plan = place_flaps(mesh, nets, {});
  const OutlineGaps gaps = outline_gaps(nets[0], plan.flaps[0]);
  EXPECT_EQ(plan.counts.full, plan.counts.wanted);
  EXPECT_LT(gaps.close, 0.05 * gaps.length);
}

}  // namespace
}  // namespace foldwright::testing
