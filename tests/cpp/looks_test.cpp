#include "mesh/looks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "mesh/polygon_soup.h"

namespace foldwright::testing {
namespace {

/// A quad of one material, whose corners have a place and a colour each, and a triangle without.
PolygonSoup quad_and_triangle() {
  constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
  PolygonSoup soup;
  soup.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}};
  soup.corners = {0, 1, 2, 3, 0, 1, 4};
  soup.first_corner = {0, 4, 7};
  soup.looks.places = {{0, 0},         {2, 0},         {2, 2},        {0, 2},
                       {kNone, kNone}, {kNone, kNone}, {kNone, kNone}};
  soup.looks.colours = {{0, 0, 0}, {200, 0, 0}, {200, 100, 0}, {0, 100, 0},
                        {9, 9, 9}, {9, 9, 9},   {9, 9, 9}};
  soup.looks.materials = {3, -1};
  return soup;
}

TEST(CarryLooks, TakesCornersAsTheyAre) {
  const PolygonSoup soup = quad_and_triangle();
  const std::vector<FaceOrigins> origins = {origins_of_triangle(0, {0, 2, 3}),
                                            origins_of_triangle(1, {0, 1, 2})};
  const FaceLooks looks = carry_looks(soup.looks, soup.first_corner, origins);
  EXPECT_EQ(looks.places[1], (PicturePlace{2, 2}));
  EXPECT_EQ(looks.colours[2], (Rgb{0, 100, 0}));
  EXPECT_TRUE(std::isnan(looks.places[3][0]));
  EXPECT_EQ(looks.colours[5], (Rgb{9, 9, 9}));
  EXPECT_EQ(looks.materials, (std::vector<int>{3, -1}));
}

TEST(CarryLooks, TakesMeansBetweenCorners) {
  const PolygonSoup soup = quad_and_triangle();
  const FaceOrigins triangle = origins_of_triangle(0, {0, 1, 2});
  const CornerOrigin middle = place_within(triangle, Vec3(0.5, 0.25, 0.25));
  const FaceLooks looks = carry_looks(soup.looks, soup.first_corner,
                                      std::vector<FaceOrigins>{{middle, middle, middle}});
  EXPECT_EQ(looks.places[0], (PicturePlace{1, 0.5}));
  EXPECT_EQ(looks.colours[0], (Rgb{100, 25, 0}));
}

TEST(CarryLooks, LeavesOutCornersThatHaveNoPartInAPlace) {
  PolygonSoup soup = quad_and_triangle();
  soup.looks.places[2] = {std::numeric_limits<float>::quiet_NaN(), 0};
  const FaceOrigins triangle = origins_of_triangle(0, {0, 1, 2});
  const CornerOrigin on_edge = place_within(triangle, Vec3(0.5, 0.5, 0));
  const CornerOrigin within = place_within(triangle, Vec3(0.5, 0.25, 0.25));
  const FaceLooks looks = carry_looks(soup.looks, soup.first_corner,
                                      std::vector<FaceOrigins>{{on_edge, within, within}});
  EXPECT_EQ(looks.places[0], (PicturePlace{1, 0}));
  EXPECT_TRUE(std::isnan(looks.places[1][0]));
}

TEST(CarryLooks, GivesNothingWhereThereIsNothing) {
  PolygonSoup soup = quad_and_triangle();
  soup.looks = {};
  const std::vector<FaceOrigins> origins = {origins_of_triangle(0, {0, 1, 2})};
  EXPECT_TRUE(carry_looks(soup.looks, soup.first_corner, origins).empty());
}

}  // namespace
}  // namespace foldwright::testing
