// Whatever a file does to a solid, it stays the solid that was drawn: as many panels, one volume.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geometry/random.h"
#include "mesh/dual_graph.h"
#include "mesh_faults.h"
#include "meshes.h"
#include "repair/repair.h"
#include "solids.h"
#include "unfold/net.h"
#include "unfold/spanning_tree.h"

namespace foldwright::testing {
namespace {

Solid moved(Solid solid, double scale, const Eigen::Quaterniond& turn, const Vec3& shift) {
  for (Vec3& p : solid.positions) p = Vec3(turn * p) * scale + shift;
  return solid;
}

Solid rounded(Solid solid, int decimals) {
  const double unit = std::pow(10.0, -decimals);
  for (Vec3& p : solid.positions) p = (p / unit).array().round().matrix() * unit;
  return solid;
}

/// Every polygon as triangles: a fan from its first corner, or from its second.
Solid triangulated(const Solid& solid, int from) {
  Solid triangles = solid;
  triangles.polygons.clear();
  for (const std::vector<int>& polygon : solid.polygons) {
    const int n = static_cast<int>(polygon.size());
    for (int i = 1; i + 1 < n; ++i) {
      triangles.polygons.push_back(
          {polygon[from], polygon[(from + i) % n], polygon[(from + i + 1) % n]});
    }
  }
  return triangles;
}

Solid shuffled(Solid solid, std::uint64_t seed) {
  Random random(seed);
  for (int i = static_cast<int>(solid.polygons.size()) - 1; i > 0; --i) {
    std::swap(solid.polygons[i], solid.polygons[random.below(i + 1)]);
  }
  for (std::vector<int>& polygon : solid.polygons) {
    std::rotate(polygon.begin(), polygon.begin() + random.below(static_cast<int>(polygon.size())),
                polygon.end());
  }
  return solid;
}

Eigen::Quaterniond any_turn(std::uint64_t seed) {
  Random random(seed);
  const auto part = [&] { return 2 * random.uniform() - 1; };
  return Eigen::Quaterniond(part(), part(), part(), part()).normalized();
}

double volume_of(const Mesh& mesh) {
  double volume = 0;
  for (const auto& [a, b, c] : mesh.faces) {
    volume += mesh.positions[a].dot(mesh.positions[b].cross(mesh.positions[c])) / 6;
  }
  return volume;
}

/// Checks panels and volume, and that nets are congruent to the repaired mesh.
void expect_drawn(const Solid& solid, double precision, double scale, const std::string& variant) {
  SCOPED_TRACE(solid.name + ", " + variant);
  const RepairedModel model = repair(soup_of(solid, precision));
  EXPECT_EQ(fault_of(model.mesh), "");
  EXPECT_EQ(bookkeeping_fault_of(model), "");
  ASSERT_EQ(model.mesh.component_count, 1);
  const DualGraph graph = build_dual_graph(model.mesh);
  EXPECT_EQ(graph.panel_count(), solid.panels);
  const std::vector<double> weights(graph.hinges.size(), 0);
  const NetCheck check =
      check_net(model.mesh, make_net(model.mesh, graph, minimum_spanning_tree(graph, weights)));
  EXPECT_LT(check.length_error, 1e-7);
  EXPECT_EQ(check.mirrored, 0);
  EXPECT_EQ(check.unconnected, 0);
  for (const Solid& drawn : drawn_solids()) {
    if (drawn.name != solid.name || border_edge_count(model.mesh) > 0) continue;
    const double wanted = volume_of(repair(soup_of(drawn, 0)).mesh);
    // Rounding moves a surface of some 30 square units by the precision, and flattening as much.
    const double rounding = 60 * precision / scale + 1e-9 * wanted;
    EXPECT_NEAR(volume_of(model.mesh) / (scale * scale * scale), wanted, rounding);
  }
}

constexpr double kDouble = 1e-15;  // what computing coordinates of about 2 leaves

TEST(DrawnSolids, StayWhenRounded) {
  for (const Solid& solid : drawn_solids()) {
    for (int decimals = 1; decimals <= 12; ++decimals) {
      expect_drawn(rounded(solid, decimals), 0.5 * std::pow(10.0, -decimals), 1,
                   std::to_string(decimals) + " decimals");
    }
  }
}

TEST(DrawnSolids, StayWhenTurnedAndRounded) {
  for (const Solid& solid : drawn_solids()) {
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      for (int decimals = 2; decimals <= 12; decimals += 2) {
        const Solid turned = moved(solid, 1, any_turn(seed), Vec3::Zero());
        expect_drawn(
            rounded(turned, decimals), 0.5 * std::pow(10.0, -decimals), 1,
            "turn " + std::to_string(seed) + ", " + std::to_string(decimals) + " decimals");
      }
    }
  }
}

TEST(DrawnSolids, StayAtAnyScale) {
  for (const Solid& solid : drawn_solids()) {
    for (int exponent = -6; exponent <= 6; ++exponent) {
      const double scale = std::pow(10.0, exponent);
      expect_drawn(moved(solid, scale, any_turn(7), Vec3::Zero()), kDouble * scale, scale,
                   "scale " + std::to_string(scale));
    }
  }
}

TEST(DrawnSolids, StayFarFromTheOrigin) {
  for (const Solid& solid : drawn_solids()) {
    const Solid far = moved(solid, 1, any_turn(8), {1e6, -1e6, 1e6});
    expect_drawn(far, std::ldexp(1, 20 - 53), 1, "offset 1e6");
    expect_drawn(rounded(far, 4), 0.5e-4, 1, "offset 1e6, 4 decimals");
  }
}

TEST(DrawnSolids, StayInSinglePrecision) {
  for (const Solid& solid : drawn_solids()) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      Solid single = triangulated(moved(solid, 50, any_turn(seed), Vec3::Zero()), 0);
      for (Vec3& p : single.positions) p = p.cast<float>().cast<double>();
      expect_drawn(single, std::ldexp(1.0, 6 - 24), 50, "turn " + std::to_string(seed));
    }
  }
}

TEST(DrawnSolids, StayWhenShuffled) {
  for (const Solid& solid : drawn_solids()) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      expect_drawn(shuffled(rounded(solid, 5), seed), 0.5e-5, 1, "order " + std::to_string(seed));
    }
  }
}

TEST(DrawnSolids, StayWhenTriangulatedEitherWay) {
  for (const Solid& solid : drawn_solids()) {
    for (const int from : {0, 1}) {
      if (solid.name == "L" && from == 1) continue;  // a fan from there leaves the L
      for (const int decimals : {3, 5, 7, 12}) {
        expect_drawn(
            triangulated(rounded(solid, decimals), from), 0.5 * std::pow(10.0, -decimals), 1,
            "from corner " + std::to_string(from) + ", " + std::to_string(decimals) + " decimals");
      }
    }
  }
}

}  // namespace
}  // namespace foldwright::testing
