#include "paper/mesh_panels.h"

#include <gtest/gtest.h>

#include "drawn_shapes.h"
#include "meshes.h"
#include "nets.h"
#include "paper/seams.h"

namespace foldwright::testing {
namespace {

/// Both ways to see what lies beyond an edge: in the mesh, and across the cut of a net.
void expect_the_same(const Mesh& mesh, double size) {
  const std::vector<Net> nets = {net_of(mesh, size)};
  const MeshPanels panels(mesh);
  for (const Seam& seam : find_seams(nets)) {
    const Mesh::Edge& edge = mesh.edges[seam.mesh_edge()];
    if (seam.mesh_edges.size() > 1) continue;
    for (const int s : {0, 1}) {
      const int face = nets[0].faces[seam.sides[s].faces.front()];
      const bool is_first = edge.faces[0] == face;
      const auto& [u, v] = edge.vertices;
      const std::array<int, 2> base = is_first ? std::array{u, v} : std::array{v, u};
      const FlapCover seen = panels.beyond(edge.faces[is_first ? 1 : 0], base, size / 2);
      const FlapCover cover = seam.cover_of(s);
      const double length = seam.sides[s].length();
      for (const double share : {0.13, 0.41, 0.57, 0.83}) {
        EXPECT_NEAR(height_at(seen, length, share * length),
                    height_at(cover, length, share * length), 1e-6);
      }
    }
  }
}

TEST(MeshPanels, AreWhatNetsShow) {
  expect_the_same(cube(), 80);
  expect_the_same(l_prism(), 80);
  expect_the_same(bumpy_sphere(200), 80);
}

}  // namespace
}  // namespace foldwright::testing
