#include "mesh/carry_origins.h"

#include <gtest/gtest.h>

#include "mesh/surface_tree.h"
#include "mesh_faults.h"
#include "meshes.h"
#include "repair/repair.h"
#include "simplify/simplify.h"

namespace foldwright::testing {
namespace {

/// Box from the origin whose six sides are grids of `side` x `side` squares, a polygon each.
PolygonSoup gridded_box(int side, const Vec3& size) {
  std::vector<Vec3> positions;
  std::vector<std::vector<int>> polygons;
  for (int axis = 0; axis < 3; ++axis) {
    for (const int end : {0, 1}) {
      const int first = static_cast<int>(positions.size());
      for (int u = 0; u <= side; ++u) {
        for (int v = 0; v <= side; ++v) {
          Vec3 p;
          p[axis] = end;
          p[(axis + 1) % 3] = static_cast<double>(u) / side;
          p[(axis + 2) % 3] = static_cast<double>(v) / side;
          positions.push_back(p.cwiseProduct(size));
        }
      }
      for (int u = 0; u < side; ++u) {
        for (int v = 0; v < side; ++v) {
          const int a = first + u * (side + 1) + v;
          const int b = a + side + 1;
          if (end == 1) polygons.push_back({a, b, b + 1, a + 1});
          if (end == 0) polygons.push_back({a, a + 1, b + 1, b});
        }
      }
    }
  }
  return soup(std::move(positions), polygons);
}

/// Side of a gridded box that a face of the file belongs to.
int side_of(int source_face, int side) { return source_face / (side * side); }

TEST(CarryOrigins, OfAMeshToItselfAreItsOwn) {
  for (const Mesh& mesh : {cube(), star(), torus(12, 8), two_sided_square()}) {
    const RepairedModel model = repair(soup_of(mesh));
    const auto carried = carry_origins(model.mesh, model.origins, model.mesh);
    ASSERT_EQ(carried.size(), model.origins.size());
    for (std::size_t f = 0; f < carried.size(); ++f) {
      for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(carried[f][i].face, model.origins[f][i].face);
        EXPECT_LT((carried[f][i].weights - model.origins[f][i].weights).norm(), 1e-12);
      }
    }
  }
}

TEST(CarryOrigins, StayOnTheirSideOfAnEdge) {
  constexpr int kSide = 8;
  // A cube, and a sheet thinner than its squares, whose two sides lie on each other almost.
  for (const Vec3& size : {Vec3(1, 1, 1), Vec3(1, 1, 1e-3)}) {
    const PolygonSoup box = gridded_box(kSide, size);
    const RepairedModel model = repair(box);
    const Mesh simple = simplify(model.mesh, {.target_faces = 60});
    const auto carried = carry_origins(model.mesh, model.origins, simple);
    EXPECT_EQ(origin_fault_of(box, model, simple, carried), "");
    EXPECT_LT(largest_deviation(model.mesh, simple), 1e-9);
    for (int f = 0; f < simple.face_count(); ++f) {
      Vec3 normal = normal_of(corners_of(simple, f));
      for (const CornerOrigin& origin : carried[f]) {
        const int side = side_of(origin.face, kSide);
        EXPECT_GT(normal[side / 2] * (side % 2 == 1 ? 1 : -1), 0.99);
      }
    }
  }
}

TEST(CarryOrigins, LieOnTheSurfaceThatWasSimplified) {
  const PolygonSoup fine = soup_of(bumpy_sphere(3000));
  const RepairedModel model = repair(fine);
  const Mesh simple = simplify(model.mesh, {.target_faces = 300});
  const auto carried = carry_origins(model.mesh, model.origins, simple);
  EXPECT_EQ(origin_fault_of(fine, model, simple, carried), "");
  const double deviation = largest_deviation(model.mesh, simple);
  EXPECT_GT(deviation, 1e-3);
  EXPECT_LT(deviation, 0.1);
}

TEST(CarryOrigins, AreThoseOfTheNearestPlaceOffTheSurface) {
  const PolygonSoup sheet = soup({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}, {{0, 1, 2, 3}});
  const RepairedModel model = repair(sheet);
  const Mesh above = make_mesh({{-1, -1, 0.5}, {1, -1, 0.5}, {0, 1, 0.5}}, {{0, 1, 2}});
  const auto carried = carry_origins(model.mesh, model.origins, above);
  for (int i = 0; i < 3; ++i) {
    const Vec3 below = above.positions[i] - Vec3(0, 0, 0.5);
    EXPECT_LT((position_at(sheet, carried[0][i]) - model.centre - below).norm(), 1e-12);
  }
}

TEST(LargestDeviation, IsTheFurthestVertexOfEither) {
  Mesh flat = open_strip(4);
  Mesh raised = flat;
  raised.positions[3].z() += 0.25;
  EXPECT_EQ(largest_deviation(flat, flat), 0);
  EXPECT_NEAR(largest_deviation(flat, raised), 0.25, 1e-12);
  EXPECT_EQ(largest_deviation(raised, flat), largest_deviation(flat, raised));
}

}  // namespace
}  // namespace foldwright::testing
