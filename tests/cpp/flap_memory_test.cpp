#include "paper/flap_memory.h"

#include <gtest/gtest.h>

#include "meshes.h"
#include "nets.h"

namespace foldwright::testing {
namespace {

std::vector<double> heights_of(const FlapPlan& plan) {
  std::vector<double> heights;
  for (const std::vector<Flap>& flaps : plan.flaps) {
    heights.push_back(-1);
    for (const Flap& flap : flaps) {
      heights.push_back(flap.edge);
      heights.push_back(flap.height);
    }
  }
  return heights;
}

TEST(FlapMemory, GivesTheFlapsThatWouldBePlaced) {
  const Mesh mesh = cube();
  std::vector<Net> nets = squares_of(mesh);
  FlapMemory memory;
  const auto expect_same = [&](const FlapOptions& options) {
    for (int again = 0; again < 2; ++again) {
      const FlapPlan plan = memory.place(mesh, nets, options);
      const FlapPlan alone = place_flaps(mesh, nets, options);
      EXPECT_EQ(heights_of(plan), heights_of(alone));
      EXPECT_EQ(plan.counts.wanted, alone.counts.wanted);
      EXPECT_EQ(plan.counts.full, alone.counts.full);
    }
  };
  FlapOptions options;
  expect_same(options);
  options.shape.height = 7;
  expect_same(options);
  options.side = FlapSide::kBoth;
  expect_same(options);
  const Mesh::Edge& edge = mesh.edges[nets[0].edges[0].mesh_edge];
  options.choices = {{edge.vertices[0], edge.vertices[1], EdgeFlaps::kNone}};
  expect_same(options);
  for (Vec2& p : nets[0].vertices) p *= 0.1;
  expect_same(options);
  expect_same({});
}

TEST(FlapMemory, TellsWhatFlapsKeepOff) {
  const Mesh mesh = cube();
  const std::vector<Net> nets = squares_of(mesh);
  FlapMemory memory;
  const FlapPlan free = memory.place(mesh, nets, {});
  const std::vector<Vec2> below = {{-90, -90}, {90, -90}, {90, 0}, {-90, 0}};
  const std::vector<std::vector<std::vector<Vec2>>> keep_off(nets.size(), {below});
  const FlapPlan bound = memory.place(mesh, nets, {}, keep_off);
  EXPECT_EQ(heights_of(bound), heights_of(place_flaps(mesh, nets, {}, keep_off)));
  EXPECT_NE(heights_of(bound), heights_of(free));
  EXPECT_EQ(heights_of(memory.place(mesh, nets, {})), heights_of(free));
}

}  // namespace
}  // namespace foldwright::testing
