#include "paper/seams.h"

#include <gtest/gtest.h>

#include <set>

#include "drawn_shapes.h"
#include "meshes.h"
#include "nets.h"

namespace foldwright::testing {
namespace {

TEST(FindSeams, TakesStraightRunsBetweenTwoPanelsAsOne) {
  const std::vector<Net> nets = {net_of(grid_cube(4), 80)};
  const std::vector<Seam> seams = find_seams(nets);
  ASSERT_EQ(seams.size(), 7u) << "as many as a cube of six squares has";
  std::set<int> edges;
  for (const Seam& seam : seams) {
    EXPECT_EQ(seam.mesh_edges.size(), 4u);
    edges.insert(seam.mesh_edges.begin(), seam.mesh_edges.end());
    for (const SeamSide& side : seam.sides) EXPECT_NEAR(side.length(), 80, 1e-9);
  }
  EXPECT_EQ(edges.size(), 28u);
}

TEST(FindSeams, BreaksARunWhereAPanelEnds) {
  // A triangulated sphere has panels of one face each.
  const std::vector<Net> nets = {net_of(bumpy_sphere(200), 80)};
  for (const Seam& seam : find_seams(nets)) EXPECT_EQ(seam.mesh_edges.size(), 1u);
}

TEST(FindSeams, CoverIsTheWholePanelBeyond) {
  const std::vector<Net> nets = {net_of(cube(), 80)};
  for (const Seam& seam : find_seams(nets)) {
    for (const int s : {0, 1}) {
      const FlapCover cover = seam.cover_of(s);
      // The square beyond goes straight up from both ends; its diagonal is no border.
      EXPECT_NEAR(cover.lean[0], 0, 1e-9);
      EXPECT_NEAR(cover.lean[1], 0, 1e-9);
      ASSERT_EQ(cover.borders.size(), 1u);
      EXPECT_NEAR(height_at(cover, 40, 20), 40, 1e-9);
    }
  }
}

TEST(FindSeams, CoverIsTheTriangleBeyond) {
  const std::vector<Net> nets = {net_of(tetrahedron(), 80)};
  for (const Seam& seam : find_seams(nets)) {
    const FlapCover cover = seam.cover_of(0);
    const double length = seam.sides[0].length();
    EXPECT_TRUE(cover.borders.empty());
    EXPECT_NEAR(height_at(cover, length, length / 2), length * std::sqrt(0.75), 1e-9);
    EXPECT_NEAR(height_at(cover, length, 0.2 * length), 0.2 * length * std::sqrt(3.0), 1e-9);
  }
}

TEST(FindBorders, TakesStraightRunsAlongAPanelAsOne) {
  const Mesh mesh = open_strip(3);
  const std::vector<Net> nets = {net_of(mesh, 60)};
  EXPECT_EQ(find_borders(mesh, nets, panels_of(nets)).size(), 4u);
}

TEST(SeamChains, HoldEverySeamOnceAndFollowBothOutlines) {
  const std::vector<Net> nets = {net_of(bumpy_sphere(300), 80)};
  const std::vector<Seam> seams = find_seams(nets);
  std::set<int> seen;
  std::size_t longest = 0;
  for (const std::vector<SeamStep>& chain : seam_chains(seams)) {
    longest = std::max(longest, chain.size());
    for (std::size_t i = 0; i < chain.size(); ++i) {
      EXPECT_TRUE(seen.insert(chain[i].seam).second);
      if (i == 0) continue;
      const auto& [last, s] = chain[i - 1];
      const auto& [next, t] = chain[i];
      EXPECT_EQ(seams[last].sides[s].to, seams[next].sides[t].from);
      EXPECT_EQ(seams[last].sides[1 - s].from, seams[next].sides[1 - t].to);
    }
  }
  EXPECT_EQ(seen.size(), seams.size());
  EXPECT_GT(longest, 2u);
}

}  // namespace
}  // namespace foldwright::testing
