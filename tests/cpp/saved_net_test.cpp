#include "pipeline/saved_net.h"

#include <gtest/gtest.h>

#include <numeric>

#include "drawn_shapes.h"
#include "meshes.h"

namespace foldwright::testing {
namespace {

/// A net of all of a component, whose folds wait for nothing and stop on their way.
FoundNet net_of(const Component& component) {
  FoundNet net{{3, 7, Cause::kNoNet, component.panels}, {}, {}};
  const std::vector<double> weights(component.graph.hinges.size(), 0);
  net.folds = minimum_spanning_tree(component.graph, weights);
  net.motion = motion_over({std::vector<double>(net.folds.size(), 0),
                            std::vector<double>(net.folds.size(), 1.0 / 3),
                            std::vector<double>(net.folds.size(), 1)});
  return net;
}

Component whole(const Mesh& mesh) {
  const DualGraph graph = build_dual_graph(mesh);
  std::vector<int> panels(graph.panel_count());
  std::iota(panels.begin(), panels.end(), 0);
  return make_component(graph, panels);
}

TEST(SavedNet, ComesBackBitByBit) {
  for (const Mesh& mesh : {torus(8, 6), l_prism(), cube(), star()}) {
    const Component component = whole(mesh);
    const FoundNet net = net_of(component);
    const SavedNet saved = save_net(component, net);
    EXPECT_EQ(saved.part, 7);
    EXPECT_EQ(saved.cause, Cause::kNoNet);
    std::vector<int> faces(mesh.faces.size());
    std::iota(faces.begin(), faces.end(), 0);
    EXPECT_EQ(saved.faces, faces);
    const FoundNet again = load_net(component, 3, saved);
    EXPECT_TRUE(again.region.kept);
    EXPECT_EQ(again.region.component, 3);
    EXPECT_EQ(again.region.part, 7);
    EXPECT_EQ(again.region.cause, Cause::kNoNet);
    EXPECT_EQ(again.region.panels, net.region.panels);
    EXPECT_EQ(again.folds, net.folds);
    EXPECT_EQ(again.motion.kind, Folding::kWaypoints);
    EXPECT_EQ(again.motion.times, net.motion.times);
    EXPECT_EQ(again.motion.shares, net.motion.shares);
  }
}

TEST(SavedNet, IsAsGoodInAComponentOfItsOwn) {
  const Mesh mesh = torus(8, 6);
  const DualGraph graph = build_dual_graph(mesh);
  const Component all = whole(mesh);
  const std::vector<int> some = {0, 1, 2, 3, 4, 5};
  const Component alone = make_component(graph, some);
  FoundNet net = net_of(alone);
  net.region.panels = some;
  const SavedNet saved = save_net(all, net);
  const FoundNet again = load_net(alone, 0, saved);
  EXPECT_EQ(again.folds, net.folds);
  EXPECT_EQ(save_net(alone, again).folds, saved.folds);
}

TEST(SavedNet, MustSpanPanelsOfTheComponent) {
  const Component component = whole(torus(8, 6));
  const SavedNet good = save_net(component, net_of(component));
  const auto expect_foreign = [&](auto&& spoil) {
    SavedNet saved = good;
    spoil(saved);
    EXPECT_THROW(load_net(component, 0, saved), InputError);
  };
  expect_foreign([](SavedNet& net) { net.faces.pop_back(); });
  expect_foreign([](SavedNet& net) { net.faces.clear(), net.folds.clear(); });
  expect_foreign([](SavedNet& net) { net.faces.push_back(net.faces[0]); });
  expect_foreign([](SavedNet& net) { net.faces.push_back(1 << 20); });
  expect_foreign([](SavedNet& net) { net.folds.pop_back(); });
  expect_foreign([](SavedNet& net) { net.folds.push_back(net.folds[0]); });
  expect_foreign([](SavedNet& net) { net.motion.times[1] = 1; });
  expect_foreign([](SavedNet& net) { net.motion.shares[1][0] = 1.5; });
  expect_foreign([](SavedNet& net) { net.motion.shares[1].pop_back(); });
  expect_foreign([](SavedNet& net) { net.motion.times.pop_back(); });
}

}  // namespace
}  // namespace foldwright::testing
