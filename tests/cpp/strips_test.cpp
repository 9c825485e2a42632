#include "paper/strips.h"

#include <gtest/gtest.h>

#include <numbers>

#include "geometry/convex2.h"
#include "meshes.h"
#include "nets.h"

namespace foldwright::testing {
namespace {

constexpr double kAngle = std::numbers::pi / 3;

TEST(MakeStrip, IsAsLongAsTheEdgeAndEightWide) {
  const std::vector<Net> nets = {net_of(cube(), 80)};
  for (const Seam& seam : find_seams(nets)) {
    const auto strip = make_strip(seam, "12", kAngle);
    ASSERT_TRUE(strip);
    EXPECT_NEAR(strip->length, 40, 1e-9);
    const Box2 box = box_of(strip->outline);
    EXPECT_NEAR(box.min[0], 0, 1e-9);
    EXPECT_NEAR(box.max[0], 40, 1e-9);
    EXPECT_NEAR(box.max[1], 4, 1e-9);
    EXPECT_NEAR(box.min[1], -4, 1e-9);
    EXPECT_EQ(strip->label.text, "12");
  }
}

/// The corner of the face beside a side that is not on it.
Vec2 corner_off(const Net& net, const SeamSide& side) {
  const auto& base = net.edges[side.edge()].vertices;
  for (const int v : net.corners[side.faces.front()]) {
    if (v != base[0] && v != base[1]) return net.vertices[v];
  }
  return Vec2::Zero();
}

TEST(MakeStrip, StaysBehindTheFacesOnBothSides) {
  const std::vector<Net> nets = {net_of(bumpy_sphere(300), 60)};
  int made = 0;
  for (const Seam& seam : find_seams(nets)) {
    const auto strip = make_strip(seam, "1", kAngle);
    if (!strip) continue;
    ++made;
    const SeamSide& side = seam.sides[0];
    const Vec2 apex = side.local(corner_off(nets[0], side));
    const Vec2 above(apex.x(), -apex.y());
    const Vec2 below_local = seam.sides[1].local(corner_off(nets[0], seam.sides[1]));
    const Vec2 below(strip->length - below_local.x(), below_local.y());
    for (const Vec2& p : strip->outline) {
      const Vec2 tip = p.y() > 0 ? above : below;
      const double turn = p.y() > 0 ? 1 : -1;
      EXPECT_GE(turn * cross(Vec2(strip->length, 0), p), -1e-9);
      EXPECT_GE(turn * cross(tip - Vec2(strip->length, 0), p - Vec2(strip->length, 0)), -1e-6);
      EXPECT_GE(turn * cross(-tip, p - tip), -1e-6);
    }
  }
  EXPECT_GT(made, 0);
}

TEST(MakeStrip, IsNoneWhereNoNumberFits) {
  const std::vector<Net> nets = {net_of(cube(), 6)};
  for (const Seam& seam : find_seams(nets)) EXPECT_FALSE(make_strip(seam, "12", kAngle));
}

class PlaceStrips : public ::testing::Test {
 protected:
  /// A sheet whose upper part a piece takes up, and strips of 40 mm.
  std::vector<Strip> place(int count, double piece_height, bool may_add) {
    const std::vector<Net> nets = {net_of(cube(), 80)};
    const StripShape shape = *make_strip(find_seams(nets)[0], "5", kAngle);
    const Footprint piece = {
        {{Vec2(0, 0), Vec2(80, 0), Vec2(80, piece_height), Vec2(0, piece_height)}}, 0};
    layout_ = {};
    layout_.sheet_width = 100;
    layout_.sheet_height = 120;
    layout_.sheet_count = 1;
    layout_.placements = {{0, 10, 110 - piece_height}};
    std::vector<Strip> strips(count);
    for (int i = 0; i < count; ++i) strips[i].mesh_edge = count - i;
    const std::vector<StripShape> shapes(count, shape);
    return place_strips({{&piece, 1}, &layout_, {}, may_add}, shapes, strips);
  }

  SheetLayout layout_;
};

TEST_F(PlaceStrips, UsesFreeRoomOnly) {
  const std::vector<Strip> strips = place(30, 60, false);
  // 37 x 80 mm are left below the piece: four rows of strips, a millimetre apart.
  EXPECT_GE(strips.size(), 6u);
  EXPECT_LT(strips.size(), 30u);
  for (std::size_t i = 0; i < strips.size(); ++i) {
    EXPECT_EQ(strips[i].sheet, 0);
    const Box2 box = box_of(strips[i].outline);
    EXPECT_GE(box.min[0], 10 - 1e-9);
    EXPECT_GE(box.min[1], 10 - 1e-9);
    EXPECT_LE(box.max[0], 90 + 1e-9);
    EXPECT_LE(box.max[1], 50 - 3 + 1e-9) << "the gap to the piece";
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_FALSE(convex_overlap(strips[i].outline, strips[j].outline, 0));
      EXPECT_LT(strips[j].mesh_edge, strips[i].mesh_edge);
    }
  }
  EXPECT_TRUE(place(5, 100, false).empty());
}

TEST_F(PlaceStrips, AddsSheetsIfItMay) {
  const std::vector<Strip> strips = place(30, 100, true);
  EXPECT_EQ(strips.size(), 30u);
  for (const Strip& strip : strips) EXPECT_GE(strip.sheet, 1);
}

}  // namespace
}  // namespace foldwright::testing
