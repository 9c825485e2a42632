#include "repair/flat_layers.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace foldwright {
namespace {

constexpr double kTolerance = 1e-6;

// A pentagon and a point above its plane.
const std::vector<Vec3> kPentagon = {{0, 0, 0}, {2, 0, 0},  {3, 2, 0},
                                     {1, 3, 0}, {-1, 2, 0}, {1, 1, 2}};

TriangleSoup triangles(std::vector<std::array<int, 3>> faces) {
  return {kPentagon, std::move(faces), {}, {}};
}

std::vector<FlatLayer> layers_of(const TriangleSoup& soup,
                                 LayerExtent extent = LayerExtent::kWhole) {
  return find_flat_layers(soup, group_half_edges(soup), kTolerance, extent);
}

TEST(FlatLayers, AreNoneWhereNothingLiesOnAnything) {
  EXPECT_TRUE(layers_of(triangles({{0, 1, 2}, {0, 2, 3}, {0, 3, 4}})).empty());
}

TEST(FlatLayers, OfOnePolygonHaveOneBorder) {
  const TriangleSoup soup =
      triangles({{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {2, 1, 4}, {2, 4, 3}, {1, 0, 4}});
  const std::vector<FlatLayer> layers = layers_of(soup);
  ASSERT_EQ(layers.size(), 2u);
  EXPECT_EQ(layers[0].faces, (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(layers[1].faces, (std::vector<int>{3, 4, 5}));
  EXPECT_EQ(layers[0].border.size(), 5u);
  EXPECT_TRUE(coincide(soup, layers[0], layers[1], kTolerance));
  EXPECT_LT(area_vector(soup, layers[0]).dot(area_vector(soup, layers[1])), 0);
}

TEST(FlatLayers, AreTakenApartAtSharedEdgesIfAskedTo) {
  // Both have the edge 0 2.
  const TriangleSoup soup =
      triangles({{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 2, 1}, {2, 0, 4}, {2, 4, 3}});
  EXPECT_EQ(layers_of(soup).size(), 2u);
  EXPECT_EQ(layers_of(soup, LayerExtent::kToSharedEdges).size(), 4u);
}

TEST(FlatLayers, DoNotEndAtAWallThatStandsOnThem) {
  const TriangleSoup soup =
      triangles({{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {1, 2, 3}, {1, 3, 4}, {1, 4, 0}, {0, 2, 5}});
  const std::vector<FlatLayer> layers = layers_of(soup);
  ASSERT_EQ(layers.size(), 2u);
  EXPECT_EQ(layers[0].border, layers[1].border);
}

TEST(FlatLayers, DoNotCoincideWhenTheyAreBent) {
  std::vector<Vec3> corners = kPentagon;
  corners[3].z() = 0.1;
  const TriangleSoup soup{
      corners, {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {2, 1, 4}, {2, 4, 3}, {1, 0, 4}}, {}, {}};
  const std::vector<FlatLayer> layers = layers_of(soup);
  for (std::size_t i = 1; i < layers.size(); ++i) {
    EXPECT_FALSE(coincide(soup, layers[i - 1], layers[i], kTolerance));
  }
}

}  // namespace
}  // namespace foldwright
