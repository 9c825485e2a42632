#include "paper/grain.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "drawn_shapes.h"
#include "meshes.h"
#include "nets.h"

namespace foldwright::testing {
namespace {

Net turned(Net net, double angle) {
  for (Vec2& p : net.vertices) {
    p = Vec2(std::cos(angle) * p.x() - std::sin(angle) * p.y(),
             std::sin(angle) * p.x() + std::cos(angle) * p.y());
  }
  return net;
}

TEST(GrainOf, IsTheDirectionOfABox) {
  const Net net = net_of(cube(), 50);
  const auto own = grain_of(net);
  ASSERT_TRUE(own);
  for (const double angle : {0.1, 0.7, 1.5, 2.0, 5.0}) {
    const auto grain = grain_of(turned(net, angle));
    ASSERT_TRUE(grain) << angle;
    EXPECT_GE(*grain, 0);
    EXPECT_LT(*grain, std::numbers::pi / 2);
    EXPECT_NEAR(std::sin(2 * (*grain - *own - angle)), 0, 1e-9) << angle;
  }
}

TEST(GrainOf, IsThatOfTheStripOfACylinder) { EXPECT_TRUE(grain_of(net_of(prism(32, 2), 50))); }

TEST(GrainOf, IsThereOnlyWhereManyLinesAreParallel) {
  EXPECT_FALSE(grain_of(net_of(bumpy_sphere(300), 50)));
  Net triangle;
  triangle.vertices = {{0, 0}, {30, 0}, {0, 40}};
  triangle.corners = {{0, 1, 2}};
  for (const auto& [a, b] : {std::array{0, 1}, {1, 2}, {2, 0}}) {
    NetEdge edge{};
    edge.vertices = {a, b};
    edge.assignment = Assignment::kCut;
    triangle.edges.push_back(edge);
  }
  EXPECT_FALSE(grain_of(triangle)) << "a right angle alone is no grain";
}

}  // namespace
}  // namespace foldwright::testing
