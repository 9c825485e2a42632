#include "mesh/nearest_face.h"

#include <gtest/gtest.h>

#include <numeric>

#include "meshes.h"
#include "simplify/simplify.h"

namespace foldwright::testing {
namespace {

Vec3 centroid(const Mesh& mesh, int face) {
  const auto& [a, b, c] = mesh.faces[face];
  return (mesh.positions[a] + mesh.positions[b] + mesh.positions[c]) / 3;
}

std::vector<int> indices(int count) {
  std::vector<int> result(count);
  std::iota(result.begin(), result.end(), 0);
  return result;
}

TEST(NearestFaces, OfAMeshToItselfAreItsOwn) {
  for (const Mesh& mesh : {cube(), star(), torus(12, 8), two_sided_square()}) {
    EXPECT_EQ(nearest_faces(mesh, mesh), indices(mesh.face_count()));
  }
}

TEST(NearestFaces, DoNotMindASmallShift) {
  const Mesh mesh = icosahedron();
  Mesh shifted = mesh;
  for (Vec3& p : shifted.positions) p += Vec3(0.05, -0.03, 0.02);
  EXPECT_EQ(nearest_faces(shifted, mesh), indices(20));
}

TEST(NearestFaces, TellTheSidesOfAThinSheetApart) {
  // A slab far thinner than its faces, seen slightly to one side of its middle.
  Mesh slab = cube();
  for (Vec3& p : slab.positions) p.z() *= 1e-3;
  Mesh shifted = slab;
  for (Vec3& p : shifted.positions) p.z() += 1e-3;
  const std::vector<int> nearest = nearest_faces(shifted, slab);
  for (int face = 0; face < 12; ++face) {
    const bool is_rim = std::abs(centroid(slab, face).z()) < 0.4e-3;
    if (is_rim) continue;
    EXPECT_EQ(nearest[face], face);
  }
}

TEST(NearestFaces, LieNearOnACoarserSurface) {
  const Mesh fine = bumpy_sphere(2000);
  const Mesh coarse = simplify(fine, {.target_faces = 200});
  const std::vector<int> nearest = nearest_faces(fine, coarse);
  const double unit = mean_edge_length(coarse);
  std::vector<char> met(coarse.faces.size(), 0);
  for (int face = 0; face < fine.face_count(); ++face) {
    met[nearest[face]] = 1;
    EXPECT_LT((centroid(fine, face) - centroid(coarse, nearest[face])).norm(), 1.5 * unit);
  }
  // All but slivers stand for something.
  EXPECT_GT(std::accumulate(met.begin(), met.end(), 0), 0.9 * coarse.face_count());
}

}  // namespace
}  // namespace foldwright::testing
