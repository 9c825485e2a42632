#include "segment/regroup.h"

#include <gtest/gtest.h>

#include <cmath>

#include "meshes.h"
#include "parts.h"

namespace foldwright::testing {
namespace {

double height_of(const Unfoldable& surface, int panel) {
  double sum = 0;
  for (const int v : surface.mesh.faces[surface.graph.panel_faces(panel)[0]]) {
    sum += surface.mesh.positions[v].z();
  }
  return sum / 3;
}

/// Parts of a dumbbell, whose axis is z: a share of its neck between what is below and above it.
Labels neck_between_bulbs(const Unfoldable& dumbbell, double from, double to) {
  Labels labels;
  for (int panel = 0; panel < dumbbell.graph.panel_count(); ++panel) {
    const double z = height_of(dumbbell, panel);
    labels.push_back(z < from ? 0 : z < to ? 1 : 2);
  }
  return labels;
}

double area_of(const Unfoldable& surface, const Labels& labels, int part) {
  double area = 0;
  for (const int panel : panels_of(labels, part)) area += surface.graph.areas[panel];
  return area;
}

TEST(Regroup, JoinsASaddleToTheBulgeItBordersOnMostAndHalvesTheOther) {
  const Unfoldable dumbbell = unfoldable(foldwright::testing::dumbbell());
  // From the middle of the neck a bit up, so that the border with the upper bulb is the longer one.
  const Labels labels = neck_between_bulbs(dumbbell, -0.35, 0.6);
  ASSERT_EQ(fault_of_parts(dumbbell.graph, labels), "");
  const auto regrouping = regroup(dumbbell.mesh, dumbbell.graph, labels, {1, 300});
  ASSERT_TRUE(regrouping);
  EXPECT_EQ(regrouping->changed, (std::vector{0, 1, 2}));
  EXPECT_EQ(fault_of_parts(dumbbell.graph, regrouping->labels), "");
  EXPECT_EQ(part_count(regrouping->labels), 3);
  for (int panel = 0; panel < dumbbell.graph.panel_count(); ++panel) {
    const int now = regrouping->labels[panel];
    if (labels[panel] == 0) {
      EXPECT_NE(now, 2) << "the lower bulb is shared by parts 0 and 1";
    } else {
      EXPECT_EQ(now, 2) << "the neck joins the upper bulb";
    }
  }
  const double lower = area_of(dumbbell, labels, 0);
  for (const int half : {0, 1}) {
    EXPECT_GT(area_of(dumbbell, regrouping->labels, half), 0.3 * lower);
  }
}

TEST(Regroup, LeavesWhatNoNeighbourBetters) {
  const Unfoldable dumbbell = unfoldable(foldwright::testing::dumbbell());
  // A bulb by itself has hardly any negative curvature: joined to the neck it has more.
  const Labels labels = neck_between_bulbs(dumbbell, -0.5, 0.5);
  EXPECT_FALSE(regroup(dumbbell.mesh, dumbbell.graph, labels, {0, 300}));
}

TEST(Regroup, NeedsAnotherPartToSplit) {
  const Unfoldable dumbbell = unfoldable(foldwright::testing::dumbbell());
  Labels labels = neck_between_bulbs(dumbbell, -0.5, 0.5);
  for (int& label : labels) label = std::min(label, 1);
  EXPECT_FALSE(regroup(dumbbell.mesh, dumbbell.graph, labels, {1, 300}));
}

TEST(RegroupSaddles, DissolvesACompactSaddleBeforeAnySearch) {
  const Unfoldable dumbbell = unfoldable(foldwright::testing::dumbbell(24));
  // Up to where the bulbs begin to bulge.
  const Labels labels = neck_between_bulbs(dumbbell, -0.4, 0.4);
  const auto regrouping = regroup(dumbbell.mesh, dumbbell.graph, labels, {1, 300});
  ASSERT_TRUE(regrouping);
  EXPECT_EQ(regroup_saddles(dumbbell.mesh, dumbbell.graph, 300, labels), regrouping->labels);
}

TEST(RegroupSaddles, LeavesBulgesAndSaddlesOfFewPanels) {
  const Unfoldable dumbbell = unfoldable(foldwright::testing::dumbbell());
  Labels halves = neck_between_bulbs(dumbbell, 0, 0);
  for (int& label : halves) label = std::min(label, 1);
  EXPECT_EQ(regroup_saddles(dumbbell.mesh, dumbbell.graph, 300, halves), halves);
  const Labels neck = neck_between_bulbs(dumbbell, -0.4, 0.4);
  ASSERT_LT(panels_of(neck, 1).size(), 50u);
  EXPECT_EQ(regroup_saddles(dumbbell.mesh, dumbbell.graph, 300, neck), neck);
}

}  // namespace
}  // namespace foldwright::testing
