#include "segment/segment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "mesh/nearest_face.h"
#include "meshes.h"
#include "parts.h"
#include "segment/mirrored_panels.h"
#include "segmentation_scores.h"
#include "simplify/simplify.h"

namespace foldwright::testing {
namespace {

constexpr Segmenter kBoth[] = {Segmenter::kShape, Segmenter::kFoldability};

/// Per panel of `fine` the panel of `coarse` nearest to its first face.
std::vector<int> rows_on(const Unfoldable& fine, const Unfoldable& coarse) {
  std::vector<int> panel_of(coarse.mesh.faces.size());
  for (int panel = 0; panel < coarse.graph.panel_count(); ++panel) {
    for (const int face : coarse.graph.panel_faces(panel)) panel_of[face] = panel;
  }
  const std::vector<int> nearest = nearest_faces(fine.mesh, coarse.mesh);
  std::vector<int> rows;
  for (int panel = 0; panel < fine.graph.panel_count(); ++panel) {
    rows.push_back(panel_of[nearest[fine.graph.panel_faces(panel)[0]]]);
  }
  return rows;
}

TEST(Segment, MakesConnectedPartsWithBothSegmenters) {
  for (const Mesh& mesh : {star(), torus(12, 8), dumbbell()}) {
    const Unfoldable surface = unfoldable(mesh);
    const FoldabilityMatrix matrix = learn(surface, 50);
    for (const Segmenter segmenter : kBoth) {
      for (const int parts : {1, 2, 5, 12}) {
        SCOPED_TRACE(parts);
        const Labels labels =
            segment(surface.mesh, surface.graph, matrix, {.segmenter = segmenter, .parts = parts});
        EXPECT_EQ(part_count(labels), parts);
        EXPECT_EQ(fault_of_parts(surface.graph, labels), "");
      }
    }
  }
}

TEST(Segment, TellsTheBallsOfADumbbellApart) {
  const Unfoldable surface = unfoldable(dumbbell());
  const FoldabilityMatrix matrix = learn(surface, 100);
  for (const int parts : {0, 2}) {
    SCOPED_TRACE(parts);
    const Labels labels = segment(surface.mesh, surface.graph, matrix, {.parts = parts});
    // The neck may be a part of its own when nobody says how many there are.
    EXPECT_GE(part_count(labels), 2);
    EXPECT_LE(part_count(labels), 3);
    std::set<int> below, above;
    for (int panel = 0; panel < surface.graph.panel_count(); ++panel) {
      double height = 0;
      for (const int v : surface.mesh.faces[surface.graph.panel_faces(panel)[0]]) {
        height += surface.mesh.positions[v].z() / 3;
      }
      if (std::abs(height) > 0.5) (height < 0 ? below : above).insert(labels[panel]);
    }
    EXPECT_EQ(below.size(), 1u);
    EXPECT_EQ(above.size(), 1u);
    EXPECT_NE(below, above);
  }
}

TEST(Segment, MakesNoPartLargerThanAllowedWhereItEstimatesTheNumber) {
  const Unfoldable surface = unfoldable(dumbbell());
  const FoldabilityMatrix matrix = learn(surface, 60);
  double total = 0;
  for (const double area : surface.graph.areas) total += area;
  const auto segmented = [&](int parts, double share) {
    return segment(surface.mesh, surface.graph, matrix,
                   {.parts = parts, .largest_area = share * total});
  };
  EXPECT_EQ(segmented(0, 1), segment(surface.mesh, surface.graph, matrix));
  EXPECT_EQ(segmented(3, 0.01), segment(surface.mesh, surface.graph, matrix, {.parts = 3}));
  for (const double share : {0.4, 0.2, 0.1}) {
    SCOPED_TRACE(share);
    const Labels labels = segmented(0, share);
    EXPECT_EQ(fault_of_parts(surface.graph, labels), "");
    std::vector<double> areas(part_count(labels), 0);
    for (int panel = 0; panel < surface.graph.panel_count(); ++panel) {
      areas[labels[panel]] += surface.graph.areas[panel];
    }
    EXPECT_LE(*std::ranges::max_element(areas), share * total);
  }
  EXPECT_LE(part_count(segmented(0, 0.001)), 20);
}

TEST(Segment, MirrorsThePartsOfASymmetricModel) {
  const Unfoldable surface = unfoldable(bilateral(600));
  const FoldabilityMatrix matrix = learn(surface, 100);
  const std::vector<int> images =
      mirrored_panels(surface.mesh, surface.graph, {Vec3::UnitX(), 0, 0});
  const std::vector<int> numbers = {0, 3, 4, 5, 6, 8, 11};
  double mean = 0;
  for (const int parts : numbers) {
    SCOPED_TRACE(parts);
    const Labels labels = segment(surface.mesh, surface.graph, matrix, {.parts = parts});
    EXPECT_EQ(fault_of_parts(surface.graph, labels), "");
    const double mirrored = mirror_symmetry(labels, surface.graph.areas, images);
    EXPECT_GT(mirrored, 0.85);
    mean += mirrored / static_cast<double>(numbers.size());
  }
  EXPECT_GT(mean, 0.95);
}

TEST(SplitInTwo, GivesTwoConnectedParts) {
  for (const Mesh& mesh : {star(), cube(), accordion({1, 1}), saddle(8, 7)}) {
    const Unfoldable surface = unfoldable(mesh);
    const FoldabilityMatrix matrix = learn(surface, 30);
    std::vector<int> rows(surface.graph.panel_count());
    std::iota(rows.begin(), rows.end(), 0);
    const Labels labels = split_in_two(surface.mesh, surface.graph, {matrix, rows});
    EXPECT_EQ(part_count(labels), 2);
    EXPECT_EQ(fault_of_parts(surface.graph, labels), "");
  }
}

TEST(CarryLabels, KeepsTheNumberOfPartsBetweenResolutions) {
  const Unfoldable fine = unfoldable(bumpy_sphere(800));
  const Unfoldable coarse = unfoldable(simplify(fine.mesh, {.target_faces = 200}));
  const FoldabilityMatrix matrix = learn(coarse, 50);
  const std::vector<int> rows = rows_on(fine, coarse);
  for (const int parts : {1, 3, 10, 40}) {
    SCOPED_TRACE(parts);
    const Labels labels = segment(coarse.mesh, coarse.graph, matrix, {.parts = parts});
    const Labels carried = carry_labels(fine.mesh, fine.graph, {matrix, rows}, labels);
    EXPECT_EQ(part_count(carried), parts);
    EXPECT_EQ(fault_of_parts(fine.graph, carried), "");
    int kept = 0;
    for (int panel = 0; panel < fine.graph.panel_count(); ++panel) {
      for (int other = 0; other < panel; ++other) {
        const bool together = labels[rows[panel]] == labels[rows[other]];
        kept += together == (carried[panel] == carried[other]);
      }
    }
    const int pairs = fine.graph.panel_count() * (fine.graph.panel_count() - 1) / 2;
    EXPECT_GT(kept, 0.95 * pairs);
  }
}

TEST(CarryLabels, MakesUpForPartsThatGotLost) {
  // All panels stand for rows of the first of three parts.
  const Unfoldable surface = unfoldable(star());
  const FoldabilityMatrix matrix = learn(surface, 30);
  const std::vector<int> rows(60, 0);
  Labels labels(60, 0);
  labels[10] = 1;
  labels[20] = 2;
  const Labels carried = carry_labels(surface.mesh, surface.graph, {matrix, rows}, labels);
  EXPECT_EQ(part_count(carried), 3);
  EXPECT_EQ(fault_of_parts(surface.graph, carried), "");
}

TEST(CarryLabels, CannotMakeMorePartsThanPanels) {
  const Unfoldable surface = unfoldable(accordion({1, 1}));
  const FoldabilityMatrix matrix{3, std::vector<float>(9, 1)};
  EXPECT_EQ(carry_labels(surface.mesh, surface.graph, {matrix, std::vector<int>{0, 1}}, {0, 1, 2}),
            (Labels{0, 1}));
}

}  // namespace
}  // namespace foldwright::testing
