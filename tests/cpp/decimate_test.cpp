#include "mesh/decimate.h"

#include <gtest/gtest.h>

#include "meshes.h"

namespace foldwright::testing {
namespace {

TEST(Decimate, WorksAtAnyScale) {
  for (const double scale : {1e-30, 1e30}) {
    Mesh fine = torus(24, 12);
    for (Vec3& p : fine.positions) p *= scale;
    EXPECT_EQ(decimate(fine, 100).faces, decimate(torus(24, 12), 100).faces);
  }
}

}  // namespace
}  // namespace foldwright::testing
