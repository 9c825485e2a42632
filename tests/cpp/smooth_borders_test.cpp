#include "segment/smooth_borders.h"

#include <gtest/gtest.h>

#include "meshes.h"
#include "parts.h"
#include "segment/connect_parts.h"
#include "segment/segment.h"

namespace foldwright::testing {
namespace {

double height(const Unfoldable& surface, int panel) {
  double sum = 0;
  for (const int v : surface.mesh.faces[surface.graph.panel_faces(panel)[0]]) {
    sum += surface.mesh.positions[v].z() / 3;
  }
  return sum;
}

double border_length(const DualGraph& graph, const Labels& labels) {
  double sum = 0;
  for (const Hinge& hinge : graph.hinges) {
    if (labels[hinge.panels[0]] != labels[hinge.panels[1]]) sum += hinge.length;
  }
  return sum;
}

/// A dumbbell cut beside its neck, through the upper ball.
Labels cut_off_neck(const Unfoldable& surface) {
  Labels labels;
  for (int panel = 0; panel < surface.graph.panel_count(); ++panel) {
    labels.push_back(height(surface, panel) > 0.7);
  }
  return labels;
}

TEST(SmoothBorders, MovesABorderIntoANeckWithinReach) {
  const Unfoldable surface = unfoldable(dumbbell());
  const Labels before = cut_off_neck(surface);
  ASSERT_EQ(fault_of_parts(surface.graph, before), "");
  const Labels after = smooth_borders(surface.mesh, surface.graph, before, {.reach = 2});
  EXPECT_EQ(fault_of_parts(surface.graph, after), "");
  EXPECT_LT(border_length(surface.graph, after), 0.5 * border_length(surface.graph, before));
}

TEST(SmoothBorders, StraightenAJaggedOneWithinReach) {
  const Unfoldable ball = unfoldable(bumpy_sphere(800));
  Labels jagged;
  for (int panel = 0; panel < ball.graph.panel_count(); ++panel) {
    jagged.push_back(height(ball, panel) > (panel % 2 == 0 ? 0.05 : -0.05));
  }
  const std::vector<int> rows(ball.graph.panel_count(), 0);
  jagged = connect_parts(ball.graph, {FoldabilityMatrix{1, {1}}, rows}, jagged);
  const Labels after = smooth_borders(ball.mesh, ball.graph, jagged, {.reach = 0.3});
  EXPECT_EQ(fault_of_parts(ball.graph, after), "");
  EXPECT_LT(border_length(ball.graph, after), 0.9 * border_length(ball.graph, jagged));
  for (int panel = 0; panel < ball.graph.panel_count(); ++panel) {
    if (std::abs(height(ball, panel)) < 0.5) continue;
    EXPECT_EQ(after[panel], jagged[panel]) << panel;
  }
  EXPECT_EQ(smooth_borders(ball.mesh, ball.graph, jagged, {.reach = 1e-6}), jagged);
}

TEST(SmoothBorders, HaveNothingToDoInOnePart) {
  const Unfoldable surface = unfoldable(star());
  const Labels one(surface.graph.panel_count(), 0);
  EXPECT_EQ(smooth_borders(surface.mesh, surface.graph, one, {.reach = 1}), one);
}

TEST(SmoothBorders, KeepEveryPartConnected) {
  for (const Mesh& mesh : {star(), torus(16, 8), dumbbell(), bumpy_sphere(300)}) {
    const Unfoldable surface = unfoldable(mesh);
    const FoldabilityMatrix matrix = learn(surface, 30);
    for (const int parts : {2, 7, 20, 50}) {
      for (const double reach : {0.1, 0.5, 5.0}) {
        SCOPED_TRACE(reach);
        const Labels labels = segment(surface.mesh, surface.graph, matrix, {.parts = parts});
        const Labels smooth = smooth_borders(surface.mesh, surface.graph, labels, {.reach = reach});
        EXPECT_EQ(part_count(smooth), parts);
        EXPECT_EQ(fault_of_parts(surface.graph, smooth), "");
      }
    }
  }
}

TEST(SmoothLabels, OnlyShortensBordersWhereTheShapeIsNoCue) {
  for (const Mesh& mesh : {star(), torus(12, 8), dumbbell()}) {
    const Unfoldable surface = unfoldable(mesh);
    const int panels = surface.graph.panel_count();
    const Labels before =
        segment(surface.mesh, surface.graph, learn(surface, 50), {Segmenter::kFoldability, 5});
    const Labels after =
        smooth_labels(surface.mesh, surface.graph, before, {Segmenter::kFoldability, panels});
    EXPECT_EQ(part_count(after), part_count(before));
    EXPECT_EQ(fault_of_parts(surface.graph, after), "");
    EXPECT_LE(border_length(surface.graph, after), border_length(surface.graph, before) + 1e-9);
  }
}

}  // namespace
}  // namespace foldwright::testing
