#include "paper/label_space.h"

#include <gtest/gtest.h>

#include "meshes.h"
#include "nets.h"

namespace foldwright::testing {
namespace {

TEST(LabelSpace, KeepsTextsOffLinesAndTexts) {
  const Net net = net_of(cube(), 80);
  LabelSpace space(net, {});
  // The middle of a square of 40 mm lies on the line within its panel, which is not drawn.
  const NetEdge* flat = nullptr;
  for (const NetEdge& edge : net.edges) {
    if (edge.assignment == Assignment::kFlat) flat = &edge;
  }
  ASSERT_NE(flat, nullptr);
  const Vec2 middle = 0.5 * (net.vertices[flat->vertices[0]] + net.vertices[flat->vertices[1]]);
  const TextBox box = {middle, {1, 0}, 5, 2};
  EXPECT_TRUE(space.is_free(box));
  EXPECT_FALSE(space.is_free({middle, {1, 0}, 25, 2}));
  EXPECT_TRUE(space.is_open({middle, middle + Vec2(0, 15)}));
  space.take(box);
  EXPECT_FALSE(space.is_free({middle + Vec2(3, 0), {1, 0}, 5, 2}));
  EXPECT_FALSE(space.is_open({middle - Vec2(0, 10), middle + Vec2(0, 10)}));
  space.take(Stroke{middle + Vec2(0, 4), middle + Vec2(0, 12)});
  EXPECT_FALSE(space.is_free({middle + Vec2(0, 8), {1, 0}, 5, 2}));
}

TEST(LabelSpace, LetsStrokesCrossFoldsButNotCuts) {
  const Net net = net_of(cube(), 80);
  const LabelSpace space(net, {});
  for (const NetEdge& edge : net.edges) {
    if (edge.assignment == Assignment::kFlat) continue;
    const Vec2 a = net.vertices[edge.vertices[0]];
    const Vec2 b = net.vertices[edge.vertices[1]];
    const Vec2 across = Vec2(a.y() - b.y(), b.x() - a.x()).normalized();
    const Vec2 middle = 0.45 * a + 0.55 * b;
    const bool is_fold = edge.assignment != Assignment::kCut;
    EXPECT_EQ(space.is_open({middle - across, middle + across}), is_fold);
  }
}

}  // namespace
}  // namespace foldwright::testing
