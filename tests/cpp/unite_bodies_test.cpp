#include "repair/unite_bodies.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "geometry/triangle3.h"
#include "meshes.h"
#include "model_text.h"
#include "repair/repair.h"
#include "sound_repair.h"

namespace foldwright::testing {
namespace {

/// Boxes that are aligned with the axes, in a row of polygons.
PolygonSoup boxes(const std::vector<Eigen::AlignedBox3d>& all, bool open_last = false) {
  std::vector<Vec3> positions;
  std::vector<std::vector<int>> polygons;
  for (const Eigen::AlignedBox3d& box : all) {
    const int first = static_cast<int>(positions.size());
    for (int i = 0; i < 8; ++i) {
      positions.push_back({(i & 1 ? box.max() : box.min()).x(), (i & 2 ? box.max() : box.min()).y(),
                           (i & 4 ? box.max() : box.min()).z()});
    }
    for (const auto& side :
         {std::array{0, 4, 6, 2}, std::array{1, 3, 7, 5}, std::array{0, 1, 5, 4},
          std::array{2, 6, 7, 3}, std::array{0, 2, 3, 1}, std::array{4, 5, 7, 6}}) {
      polygons.emplace_back();
      for (const int corner : side) polygons.back().push_back(first + corner);
    }
  }
  if (open_last) polygons.pop_back();
  return soup(positions, polygons);
}

/// A cube, and a bar that stands out of the middle of its side at x = 1.
const Eigen::AlignedBox3d kCube(Vec3(0, 0, 0), Vec3(1, 1, 1));
const Eigen::AlignedBox3d kBar(Vec3(0.5, 0.25, 0.25), Vec3(1.5, 0.75, 0.75));

/// The face of some solids, counted through all, on which three points lie; -1 for none.
int face_under(const std::vector<Solid>& solids, const Triangle3& points) {
  int number = 0;
  for (const Solid& solid : solids) {
    for (const auto& [a, b, c] : solid.faces) {
      const Triangle3 face = {solid.positions[a], solid.positions[b], solid.positions[c]};
      const auto is_on = [&](const Vec3& p) { return (closest_point(face, p) - p).norm() < 1e-12; };
      if (is_on(points[0]) && is_on(points[1]) && is_on(points[2])) return number;
      ++number;
    }
  }
  return -1;
}

/// Adds a quad cut along the diagonal that lies within faces of the solids.
void add_quad(UnitedSolids& united, const std::vector<Solid>& solids,
              const std::array<int, 4>& quad) {
  for (int turn = 0; turn < 2; ++turn) {
    const auto corner = [&](int k) { return quad[(k + turn) % 4]; };
    const auto triangle = [&](int a, int b, int c) -> std::array<int, 3> {
      return {corner(a), corner(b), corner(c)};
    };
    const std::array halves = {triangle(0, 1, 2), triangle(0, 2, 3)};
    std::array<int, 2> sources;
    for (int i = 0; i < 2; ++i) {
      const auto& [a, b, c] = halves[i];
      sources[i] =
          face_under(solids, {united.positions[a], united.positions[b], united.positions[c]});
    }
    if (sources[0] == -1 || sources[1] == -1) continue;
    united.faces.insert(united.faces.end(), halves.begin(), halves.end());
    united.sources.insert(united.sources.end(), sources.begin(), sources.end());
    return;
  }
  ADD_FAILURE() << "a face comes from nowhere";
}

/// The surface of the cube and the bar, at the places that their solids have.
std::optional<UnitedSolids> unite_cube_and_bar(const std::vector<Solid>& solids) {
  EXPECT_EQ(solids.size(), 2u);
  Eigen::AlignedBox3d cube;
  Eigen::AlignedBox3d bar;
  for (const Vec3& p : solids[0].positions) cube.extend(p);
  for (const Vec3& p : solids[1].positions) bar.extend(p);
  UnitedSolids united;
  const auto add_square = [&](const Eigen::AlignedBox3d& box, double x) {
    united.positions.push_back({x, box.min().y(), box.min().z()});
    united.positions.push_back({x, box.max().y(), box.min().z()});
    united.positions.push_back({x, box.max().y(), box.max().z()});
    united.positions.push_back({x, box.min().y(), box.max().z()});
  };
  // Squares of four vertices, seen from x counter-clockwise: 0 far, 4 near, 8 foot and 12 top of
  // the bar, and 16 the middles of the edges of its foot, where diagonals meet them.
  add_square(cube, cube.min().x());
  add_square(cube, cube.max().x());
  add_square(bar, cube.max().x());
  add_square(bar, bar.max().x());
  for (int k = 0; k < 4; ++k) {
    united.positions.push_back(0.5 * (united.positions[8 + k] + united.positions[8 + (k + 1) % 4]));
  }
  add_quad(united, solids, {0, 3, 2, 1});
  add_quad(united, solids, {12, 13, 14, 15});
  const auto add = [&](int a, int b, int c) {
    united.faces.push_back({a, b, c});
    united.sources.push_back(
        face_under(solids, {united.positions[a], united.positions[b], united.positions[c]}));
    EXPECT_NE(united.sources.back(), -1);
  };
  for (int k = 0; k < 4; ++k) {
    const int next = (k + 1) % 4;
    const int middle = 16 + k;
    add_quad(united, solids, {k, next, 4 + next, 4 + k});
    add(4 + k, 4 + next, middle);
    add(4 + next, 8 + next, middle);
    add(4 + k, middle, 8 + k);
    add(middle, 12 + k, 8 + k);
    add(middle, 12 + next, 12 + k);
    add(middle, 8 + next, 12 + next);
  }
  return united;
}

RepairedModel united(const PolygonSoup& soup, const SolidUniter& uniter) {
  return sound_repair(soup, {.unite = true, .uniter = uniter});
}

/// The only parameter of a repair, besides its count.
double parameter_of(const RepairedModel& model, std::string_view code) {
  return std::get<double>(repair_named(model.repairs, code).parameters.at(0).value);
}

TEST(UniteBodies, MakesOneSurfaceOfBodiesThatCross) {
  const RepairedModel model = united(boxes({kCube, kBar}), unite_cube_and_bar);
  EXPECT_EQ(model.mesh.component_count, 1);
  EXPECT_NEAR(signed_volume(model.mesh, 0), 1 + 0.5 * 0.25, 1e-12);
  EXPECT_EQ(count_of(model, "united-bodies"), 2);
  EXPECT_EQ(count_of(model, "crossing-bodies"), 0);
  EXPECT_EQ(count_of(model, "not-united"), 0);
}

TEST(UniteBodies, LeavesBodiesAloneThatAreApart) {
  const Eigen::AlignedBox3d far(Vec3(3, 0, 0), Vec3(4, 1, 1));
  const RepairedModel model = united(boxes({kCube, far, kBar}), unite_cube_and_bar);
  EXPECT_EQ(model.mesh.component_count, 2);
  EXPECT_EQ(count_of(model, "united-bodies"), 2);
  // Its six sides are the first that are left.
  EXPECT_EQ(model.mesh.source_faces[0], 6);
}

TEST(UniteBodies, CallsForNoUniterWhereNothingCrosses) {
  const Eigen::AlignedBox3d far(Vec3(3, 0, 0), Vec3(4, 1, 1));
  const auto unused = [](const std::vector<Solid>&) -> std::optional<UnitedSolids> {
    ADD_FAILURE() << "called";
    return std::nullopt;
  };
  EXPECT_EQ(united(boxes({kCube, far}), unused).mesh.component_count, 2);
}

TEST(UniteBodies, TellsWhatStaysApart) {
  for (const SolidUniter& uniter : {SolidUniter(), SolidUniter([](const std::vector<Solid>&) {
                                      return std::optional<UnitedSolids>();
                                    })}) {
    const RepairedModel model = united(boxes({kCube, kBar}), uniter);
    EXPECT_EQ(count_of(model, "not-united"), 2);
    EXPECT_EQ(parameter_of(model, "not-united"), 0);
    EXPECT_EQ(count_of(model, "crossing-bodies"), 1);
  }
  // What is open has no inside, and is not handed to the uniter.
  const RepairedModel model = united(boxes({kCube, kBar}, true), unite_cube_and_bar);
  EXPECT_EQ(count_of(model, "not-united"), 1);
  EXPECT_EQ(parameter_of(model, "not-united"), 1);
  EXPECT_EQ(count_of(model, "crossing-bodies"), 1);
  EXPECT_EQ(model.mesh.component_count, 2);
}

TEST(UniteBodies, TellsWhetherThereIsSomethingToUnite) {
  const auto unitable = [](const PolygonSoup& soup) {
    return parameter_of(repair(soup), "crossing-bodies");
  };
  EXPECT_EQ(unitable(boxes({kCube, kBar})), 1);
  EXPECT_EQ(unitable(boxes({kCube, kBar}, true)), 0);
}

}  // namespace
}  // namespace foldwright::testing
