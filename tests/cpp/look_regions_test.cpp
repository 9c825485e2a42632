#include "mesh/look_regions.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "meshes.h"

namespace foldwright::testing {
namespace {

int count(const std::vector<int>& regions) {
  return static_cast<int>(std::set(regions.begin(), regions.end()).size());
}

TEST(LookRegions, AreOneWhereAllLooksAlike) {
  const Mesh mesh = cube();
  FaceLooks looks;
  EXPECT_EQ(count(look_regions(mesh, looks)), 1);
  looks.materials.assign(12, 4);
  looks.colours.assign(36, {9, 8, 7});
  looks.places.assign(36, {std::numeric_limits<float>::quiet_NaN(), 0.5f});
  EXPECT_EQ(count(look_regions(mesh, looks)), 1);
}

TEST(LookRegions, PartWhereMaterialsDiffer) {
  const Mesh strip = open_strip(4);
  FaceLooks looks;
  looks.materials = {0, 0, 0, 0, 1, 1, 0, 0};
  const std::vector<int> regions = look_regions(strip, looks);
  EXPECT_EQ(regions, (std::vector{0, 0, 0, 0, 4, 4, 6, 6}));
}

TEST(LookRegions, PartWhereColoursOrPlacesJumpAndNotWhereTheyGoOn) {
  const Mesh strip = open_strip(4);
  FaceLooks even;
  FaceLooks jumping;
  for (int f = 0; f < strip.face_count(); ++f) {
    for (const int v : strip.faces[f]) {
      const auto across = static_cast<float>(strip.positions[v].x() / 8);
      even.places.push_back({across, 0});
      jumping.places.push_back({across + (f < 4 ? 0.0f : 0.5f), 0});
      const auto red = static_cast<std::uint8_t>(100 + 100 * across);
      even.colours.push_back({red, 0, 0});
    }
  }
  EXPECT_EQ(count(look_regions(strip, even)), 1);
  EXPECT_EQ(count(look_regions(strip, jumping)), 2);
  for (int corner = 12; corner < 24; ++corner) even.colours[corner][2] = 200;
  EXPECT_EQ(count(look_regions(strip, even)), 2);
}

}  // namespace
}  // namespace foldwright::testing
