#include "segment/subdivide.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "meshes.h"
#include "parts.h"

namespace foldwright::testing {
namespace {

TEST(Subdivide, MakesAsManyConnectedPartsAsAskedFor) {
  for (const Mesh& mesh : {torus(8, 6), star(), random_hull(2, 40), accordion({1, 2, 1, 2})}) {
    const Unfoldable part = unfoldable(mesh);
    const FoldabilityMatrix matrix = learn(part, 20);
    const int panels = part.graph.panel_count();
    for (const int parts : {1, 2, 3, panels - 1, panels}) {
      SCOPED_TRACE(parts);
      const Labels labels = subdivide(part.mesh, part.graph, matrix, {parts, 1});
      EXPECT_EQ(fault_of_parts(part.graph, labels), "");
      EXPECT_EQ(part_count(labels), parts);
      EXPECT_EQ(subdivide(part.mesh, part.graph, matrix, {parts, 1}), labels);
    }
  }
}

TEST(Subdivide, CutsADumbbellAtItsNeck) {
  const Unfoldable part = unfoldable(dumbbell());
  const Labels labels = subdivide(part.mesh, part.graph, learn(part, 50), {2, 1});
  const auto first = std::ranges::count(labels, 0);
  EXPECT_NEAR(static_cast<double>(first) / std::ssize(labels), 0.5, 0.1);
}

}  // namespace
}  // namespace foldwright::testing
