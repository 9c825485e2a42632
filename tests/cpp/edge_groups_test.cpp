#include "repair/edge_groups.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "geometry/random.h"
#include "meshes.h"

namespace foldwright::testing {
namespace {

TriangleSoup soup_with(std::vector<std::array<int, 3>> faces, const Mesh& mesh) {
  return {.positions = mesh.positions, .faces = std::move(faces), .source_faces = {}};
}

/// Per pair of vertices, the lower first: the half-edges between them, ascending.
std::map<std::pair<int, int>, std::vector<int>> groups_by_map(const TriangleSoup& soup) {
  std::map<std::pair<int, int>, std::vector<int>> groups;
  for (int h = 0; h < 3 * soup.face_count(); ++h) {
    groups[std::minmax({start_vertex(soup, h), end_vertex(soup, h)})].push_back(h);
  }
  return groups;
}

TEST(EdgeGroups, AreInTheOrderOfTheirVertices) {
  const Mesh mesh = torus(12, 7);
  Random random(5);
  for (int round = 0; round < 5; ++round) {
    // Faces in any order and winding, some of them twice, some vertices without any.
    std::vector<std::array<int, 3>> faces;
    for (int i = 0; i < 150; ++i) {
      auto face = mesh.faces[random.below(mesh.face_count())];
      if (random.below(2) == 0) std::swap(face[0], face[1]);
      faces.push_back(face);
    }
    const TriangleSoup soup = soup_with(faces, mesh);
    const EdgeGroups groups = group_half_edges(soup);
    const auto expected = groups_by_map(soup);
    ASSERT_EQ(groups.count(), static_cast<int>(expected.size()));
    int g = 0;
    for (const auto& [vertices, half_edges] : expected) {
      const auto group = groups.group(g++);
      EXPECT_TRUE(std::ranges::equal(group, half_edges));
    }
  }
}

TEST(EdgeGroups, AreNoneWithoutFaces) {
  EXPECT_EQ(group_half_edges(soup_with({}, cube())).count(), 0);
}

}  // namespace
}  // namespace foldwright::testing
