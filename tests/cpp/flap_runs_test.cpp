#include "paper/flap_runs.h"

#include <gtest/gtest.h>

#include <map>

#include "drawn_shapes.h"
#include "nets.h"
#include "paper/flaps.h"

namespace foldwright::testing {
namespace {

constexpr int kSides = 24;
constexpr double kSize = 80;  // of the net; its bases at the caps are about 10 mm long

/// The lengths of the tops of the flaps at the caps of a round drum, by style.
std::vector<double> tops(FlapStyle style, double size) {
  const Mesh mesh = prism(kSides, 1);
  const std::vector<Net> nets = {net_of(mesh, size)};
  const FlapPlan plan = place_flaps(mesh, nets, {.style = style});
  std::vector<double> found;
  for (const Flap& flap : plan.flaps[0]) {
    const Vec2 base = nets[0].vertices[flap.base[1]] - nets[0].vertices[flap.base[0]];
    // The one along the drum's height is no part of a run.
    if (base.norm() < 0.5 * size) found.push_back((flap.corners[2] - flap.corners[1]).norm());
  }
  return found;
}

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

TEST(FindRuns, GoOnWhereSeamsOfOneChainBendGently) {
  const Mesh mesh = prism(kSides, 1);
  const std::vector<Net> nets = {net_of(mesh, kSize)};
  const std::vector<Seam> seams = find_seams(nets);
  std::map<int, int> ends;  // how many sides have so many ends at which a run goes on
  for (const RunEnds& run : find_runs(seams)) {
    for (const auto& side : run) ++ends[side[0] + side[1]];
  }
  EXPECT_GT(ends[2], kSides) << "most within the two runs around the caps";
  EXPECT_GT(ends[1], 0) << "where those begin and end";

  // Around a hexagon the outline bends by 60 degrees, and only along the drum it goes straight on.
  const Mesh drum = prism(6, 1);
  const std::vector<Net> hexagons = {net_of(drum, kSize)};
  for (const RunEnds& run : find_runs(find_seams(hexagons))) {
    EXPECT_FALSE((run[0][0] || run[0][1]) && (run[1][0] || run[1][1]));
  }
}

TEST(PlaceFlaps, LooksInRunsAsItsStyleSays) {
  const std::vector<double> edge = tops(FlapStyle::kEdge, kSize);
  const std::vector<double> run = tops(FlapStyle::kRun, kSize);
  const std::vector<double> zigzag = tops(FlapStyle::kZigzag, kSize);
  ASSERT_FALSE(edge.empty());
  EXPECT_EQ(run.size(), edge.size());
  EXPECT_GT(mean(run), mean(edge) + 2) << "narrow notches leave more to glue";
  EXPECT_LT(mean(zigzag), mean(edge));
}

TEST(PlaceFlaps, LeavesLongFlapsAsTheyAre) {
  EXPECT_EQ(tops(FlapStyle::kRun, 10 * kSize), tops(FlapStyle::kEdge, 10 * kSize));
}

TEST(ToothOf, EndsInAPointAboveItsMiddle) {
  const Trapezoid tooth = tooth_of({5, {0, 10}, {3, 7}});
  EXPECT_EQ(tooth.height, 5);
  EXPECT_NEAR(0.5 * (tooth.top[0] + tooth.top[1]), 5, 1e-12);
  EXPECT_LT(tooth.top[1] - tooth.top[0], 0.5);
}

}  // namespace
}  // namespace foldwright::testing
