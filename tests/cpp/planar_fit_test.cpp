#include "repair/planar_fit.h"

#include <gtest/gtest.h>

namespace foldwright {
namespace {

TEST(PlanarFit, MeasuresHowFarFacesAreFromFlat) {
  // A square, one corner lifted: the plane lies halfway.
  const TriangleSoup soup{
      {{0, 0, 0}, {1, 0, 0}, {1, 1, 0.02}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}, {0, 0}, {}};
  const PlanarFit fit = fit_plane(soup, std::vector<int>{0, 1});
  EXPECT_NEAR(fit.deviation, 0.005, 1e-4);
  EXPECT_NEAR(fit.area, 1, 1e-3);
  EXPECT_NEAR(fit.extent, std::sqrt(2.0), 0.5);
  EXPECT_TRUE(fit.upright);
}

TEST(PlanarFit, SeesFacesWithTheirBackUp) {
  const TriangleSoup soup{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0.9, 0.5, 0}},
                          {{0, 1, 2}, {1, 2, 3}, {2, 1, 3}},
                          {0, 0, 0},
                          {}};
  EXPECT_TRUE(fit_plane(soup, std::vector<int>{0, 1}).upright);
  EXPECT_FALSE(fit_plane(soup, std::vector<int>{0, 2}).upright);
}

}  // namespace
}  // namespace foldwright
