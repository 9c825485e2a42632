#include "repair/mend_bodies.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "meshes.h"
#include "model_text.h"
#include "repair/repair.h"
#include "sound_repair.h"

namespace foldwright::testing {
namespace {

const Vec3 kHere = Vec3::Zero();

/// A mesh of a size at a place, with its inside out if that is asked for.
PolygonSoup placed(const Mesh& mesh, double size, const Vec3& at = kHere, bool inside_out = false) {
  std::vector<Vec3> positions;
  std::vector<std::vector<int>> polygons;
  for (const Vec3& p : mesh.positions) positions.push_back(size * p + at);
  for (const auto& face : mesh.faces) {
    polygons.push_back({face.begin(), face.end()});
    if (inside_out) std::reverse(polygons.back().begin(), polygons.back().end());
  }
  return soup(positions, polygons);
}

PolygonSoup together(const std::vector<PolygonSoup>& soups) {
  std::vector<Vec3> positions;
  std::vector<std::vector<int>> polygons;
  for (const PolygonSoup& soup : soups) {
    const int offset = static_cast<int>(positions.size());
    positions.insert(positions.end(), soup.positions.begin(), soup.positions.end());
    for (int f = 0; f < soup.face_count(); ++f) {
      polygons.push_back(corners_of(soup, f));
      for (int& corner : polygons.back()) corner += offset;
    }
  }
  return soup(positions, polygons);
}

/// Repairs.
RepairedModel mended(const PolygonSoup& soup, bool drop_inner = false) {
  return sound_repair(soup, {.drop_inner = drop_inner});
}

int inner_bodies(const PolygonSoup& soup) {
  const RepairedModel model = mended(soup);
  EXPECT_EQ(count_of(mended(soup, true), "dropped-inner-bodies"), count_of(model, "inner-bodies"));
  return count_of(model, "inner-bodies");
}

/// Of all components together.
double volume_of(const Mesh& mesh) {
  double volume = 0;
  for (int c = 0; c < mesh.component_count; ++c) volume += signed_volume(mesh, c);
  return volume;
}

TEST(MendBodies, KeepsACavity) {
  const PolygonSoup hollow = together({placed(cube(), 1), placed(cube(), 0.5, kHere, true)});
  const RepairedModel model = mended(hollow);
  EXPECT_EQ(model.mesh.component_count, 2);
  EXPECT_EQ(count_of(model, "inner-bodies"), 1);
  EXPECT_EQ(count_of(model, "flipped-faces"), 0);
  EXPECT_NEAR(volume_of(model.mesh), 1 - 0.125, 1e-12);
}

TEST(MendBodies, KeepsACavityInAModelThatIsInsideOut) {
  const RepairedModel model =
      mended(together({placed(cube(), 1, kHere, true), placed(cube(), 0.5)}));
  EXPECT_NEAR(volume_of(model.mesh), 1 - 0.125, 1e-12);
  EXPECT_EQ(count_of(model, "flipped-faces"), 24);
}

TEST(MendBodies, KeepsASolidBodyInACavity) {
  const RepairedModel model = mended(together({placed(cube(), 1), placed(cube(), 0.8, kHere, true),
                                               placed(star(), 0.1), placed(cube(), 1, {3, 0, 0})}));
  EXPECT_EQ(count_of(model, "inner-bodies"), 2);
  EXPECT_NEAR(volume_of(model.mesh), 2 - 0.512 + signed_volume(star()) * 1e-3, 1e-9);
}

TEST(MendBodies, WindsOutwardsWhatTheFileWindsBothWays) {
  PolygonSoup inner = placed(cube(), 0.5, kHere, true);
  std::swap(inner.corners[0], inner.corners[1]);
  const RepairedModel model = mended(together({placed(cube(), 1), inner}));
  EXPECT_NEAR(volume_of(model.mesh), 1.125, 1e-12);
  EXPECT_EQ(count_of(model, "flipped-faces"), 11);
}

TEST(MendBodies, LeavesInnerBodiesOut) {
  const PolygonSoup nested =
      together({placed(cube(), 0.2), placed(cube(), 1), placed(star(), 0.2, {0, 0, 3}),
                placed(cube(), 0.5, kHere, true)});
  const RepairedModel model = mended(nested, true);
  EXPECT_EQ(model.mesh.component_count, 2);
  EXPECT_EQ(model.mesh.face_count(), 12 + 60);
  EXPECT_EQ(count_of(model, "dropped-inner-bodies"), 2);
  EXPECT_EQ(count_of(model, "inner-bodies"), 0);
  EXPECT_EQ(std::ranges::min(model.mesh.source_faces), 12);
}

TEST(MendBodies, DoesNotTellOfCrossingsAmongWhatIsLeftOut) {
  const PolygonSoup nested =
      together({placed(cube(), 4), placed(cube(), 1), placed(cube(), 1, {0.5, 0.4, 0.3})});
  EXPECT_EQ(count_of(mended(nested), "crossing-bodies"), 1);
  EXPECT_EQ(count_of(mended(nested, true), "crossing-bodies"), 0);
}

TEST(MendBodies, FindsWhatTouchesFromWithin) {
  // A side in the plane of a side; an edge and a corner of the outer cube, welded.
  EXPECT_EQ(inner_bodies(together({placed(cube(), 1), placed(cube(), 0.5, {0.25, 0.1, 0})})), 1);
  EXPECT_EQ(inner_bodies(together({placed(cube(), 1), placed(cube(), 0.5, {0.25, 0.25, 0})})), 1);
  EXPECT_EQ(inner_bodies(together({placed(cube(), 1), placed(cube(), 0.5, {0.25, 0.25, 0.25})})),
            1);
}

TEST(MendBodies, FindsThinShells) {
  EXPECT_EQ(inner_bodies(together(
                {placed(bumpy_sphere(800), 1), placed(bumpy_sphere(800), 0.97, kHere, true)})),
            1);
}

TEST(MendBodies, TakesNothingElseForInner) {
  const std::vector<PolygonSoup> others = {
      placed(cube(), 0.5, {1.5, 0, 0}),     // beside it
      placed(cube(), 0.5, {0.75, 0.1, 0}),  // touching from outside
      placed(cube(), 0.5, {0.4, 0.1, 0}),   // standing out of it
      placed(open_strip(1), 0.2),           // open
      placed(cube(), 1),                    // the same again
  };
  for (const PolygonSoup& other : others) {
    EXPECT_EQ(inner_bodies(together({placed(cube(), 1), other})), 0);
  }
  // In the hole of a ring, and through it.
  EXPECT_EQ(inner_bodies(together({placed(torus(24, 12), 1), placed(cube(), 0.5)})), 0);
  // In an open box.
  PolygonSoup open = placed(cube(), 1);
  open.corners.resize(30);
  open.first_corner.resize(11);
  EXPECT_EQ(inner_bodies(together({open, placed(cube(), 0.5)})), 0);
}

TEST(MendBodies, FindsManySmallBodiesInALargeOne) {
  std::vector<PolygonSoup> soups = {placed(bumpy_sphere(2000), 10)};
  for (int i = 0; i < 1000; ++i) {
    soups.push_back(placed(cube(), 0.1, Vec3(i % 10, i / 10 % 10, i / 100) - Vec3(4.5, 4.5, 4.5)));
  }
  EXPECT_EQ(inner_bodies(together(soups)), 1000);
}

}  // namespace
}  // namespace foldwright::testing
