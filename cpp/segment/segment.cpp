#include "segment/segment.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "segment/concave_geodesic.h"
#include "segment/connect_parts.h"
#include "segment/hinge_measures.h"
#include "segment/mirrored_panels.h"
#include "segment/smooth_borders.h"
#include "segment/spectral.h"
#include "segment/subdivide.h"

namespace foldwright {
namespace {

// The number of parts shows best when distances count for more.
constexpr ShapeCue kCuesForCounting[] = {{.power = 3, .falloff = 0.3},
                                         {.power = 4, .falloff = 0.3},
                                         {.power = 5, .falloff = 0.3},
                                         {.power = 3, .falloff = 0.25},
                                         {.power = 4, .falloff = 0.25}};

// Borders may move so far, in sides of a square as large as a panel that was learned on: finer than
// that learning cannot place them.
constexpr double kBorderReach = 1;

std::vector<int> panels_of(const Labels& labels, int part) {
  std::vector<int> panels;
  for (int panel = 0; panel < static_cast<int>(labels.size()); ++panel) {
    if (labels[panel] == part) panels.push_back(panel);
  }
  return panels;
}

/// The part of largest area that has more than one panel; -1 when there is none.
int largest_divisible(const DualGraph& graph, const Labels& labels) {
  const std::vector<double> area = part_areas(graph, labels);
  std::vector<int> size(area.size(), 0);
  for (const int label : labels) ++size[label];
  int best = -1;
  for (int part = 0; part < static_cast<int>(area.size()); ++part) {
    if (size[part] > 1 && (best == -1 || area[part] > area[best])) best = part;
  }
  return best;
}

std::vector<int> rows_of(const CarriedFoldability& foldability, std::span<const int> panels) {
  std::vector<int> rows;
  for (const int panel : panels) rows.push_back(foldability.rows[panel]);
  return rows;
}

std::vector<int> each_row(int count) {
  std::vector<int> rows(count);
  std::iota(rows.begin(), rows.end(), 0);
  return rows;
}

/// Per panel the one where its mirror image is; empty where there is no mirror plane.
std::vector<int> mirror_images(const Mesh& mesh, const DualGraph& graph) {
  const std::optional<Mirror> mirror = find_mirror(mesh, graph.faces);
  return mirror ? mirrored_panels(mesh, graph, *mirror) : std::vector<int>{};
}

/// What panels are clustered by, and counted by where nobody says how many parts there are.
struct Cues {
  Affinity affinity;
  std::vector<Affinity> for_counting;
  std::vector<int> images;  ///< of panels in the mirror, or none
};

Cues cues_of(const Mesh& mesh, const DualGraph& graph, const FoldabilityMatrix& matrix,
             const SegmentOptions& options) {
  if (options.segmenter == Segmenter::kFoldability) {
    const Affinity affinity = foldability_affinity(matrix);
    return {affinity, {affinity}, {}};
  }
  const std::vector<float> geodesic = concave_geodesic(mesh, graph);
  Cues cues{shape_affinity(matrix, geodesic), {}, mirror_images(mesh, graph)};
  if (options.parts > 0 || options.whole_first) return cues;
  for (const ShapeCue& cue : kCuesForCounting) {
    cues.for_counting.push_back(shape_affinity(matrix, geodesic, cue));
  }
  return cues;
}

/// Divides parts of more area than allowed, the largest first.
Labels divide_large(const Mesh& mesh, const DualGraph& graph, const FoldabilityMatrix& matrix,
                    const SegmentOptions& options, Labels labels) {
  for (int count = part_count(labels); count < kMostEstimatedParts; count = part_count(labels)) {
    const int part = largest_divisible(graph, labels);
    if (part == -1) break;
    const double excess = part_areas(graph, labels)[part] / options.largest_area;
    if (excess <= 1) break;
    const std::vector<int> panels = panels_of(labels, part);
    const int most = std::min(static_cast<int>(panels.size()), kMostEstimatedParts - count + 1);
    const auto pieces = static_cast<int>(std::min(std::ceil(excess), static_cast<double>(most)));
    const Labels divided = subdivide(mesh, restrict_to(graph, panels), restrict_to(matrix, panels),
                                     {.parts = pieces, .seed = options.seed});
    for (std::size_t i = 0; i < panels.size(); ++i) {
      if (divided[i] > 0) labels[panels[i]] = count + divided[i] - 1;
    }
  }
  return renumbered(labels);
}

}  // namespace

Labels segment(const Mesh& mesh, const DualGraph& graph, const FoldabilityMatrix& matrix,
               const SegmentOptions& options) {
  assert(options.parts <= graph.panel_count());
  const Cues cues = cues_of(mesh, graph, matrix, options);
  int parts = options.parts;
  if (parts == 0) parts = options.whole_first ? 1 : estimate_parts(cues.for_counting);
  Labels labels = spectral_clusters(cues.affinity,
                                    {.parts = parts, .seed = options.seed, .images = cues.images});
  labels = connect_parts(graph, {matrix, each_row(graph.panel_count())}, std::move(labels));
  if (options.parts > 0 || options.segmenter == Segmenter::kFoldability) return labels;
  return divide_large(mesh, graph, matrix, options, std::move(labels));
}

Labels carry_labels(const Mesh& mesh, const DualGraph& graph, const CarriedFoldability& foldability,
                    const Labels& labels) {
  Labels carried;
  for (const int row : foldability.rows) carried.push_back(labels[row]);
  carried = connect_parts(graph, foldability, std::move(carried));
  const int wanted = part_count(labels);
  for (int count = part_count(carried); count < wanted; ++count) {
    const int part = largest_divisible(graph, carried);
    if (part == -1) break;
    const std::vector<int> panels = panels_of(carried, part);
    const Labels halves = split_in_two(mesh, restrict_to(graph, panels),
                                       {foldability.matrix, rows_of(foldability, panels)});
    for (std::size_t i = 0; i < panels.size(); ++i) {
      if (halves[i] == 1) carried[panels[i]] = count;
    }
  }
  return renumbered(carried);
}

Labels smooth_labels(const Mesh& mesh, const DualGraph& graph, Labels labels,
                     const LearnedBy& learned) {
  const double area = std::accumulate(graph.areas.begin(), graph.areas.end(), 0.0);
  BorderCost cost{.reach = kBorderReach * std::sqrt(area / learned.panels)};
  if (learned.segmenter == Segmenter::kFoldability) cost.crease = 0;
  return smooth_borders(mesh, graph, std::move(labels), cost);
}

Labels halve(const Mesh& mesh, const DualGraph& graph) {
  const std::vector<double> lengths = hinge_distances(mesh, graph);
  const auto farthest = [&](const std::vector<double>& distances) {
    const auto it = std::max_element(distances.begin(), distances.end());
    return static_cast<int>(it - distances.begin());
  };
  const int one = farthest(distances_from(graph, lengths, 0));
  const std::vector<double> from_one = distances_from(graph, lengths, one);
  const std::vector<double> from_other = distances_from(graph, lengths, farthest(from_one));
  // Each half is connected, because it holds the shortest ways to its panel.
  Labels halves;
  for (int panel = 0; panel < graph.panel_count(); ++panel) {
    halves.push_back(from_other[panel] < from_one[panel]);
  }
  return halves;
}

Labels split_in_two(const Mesh& mesh, const DualGraph& graph,
                    const CarriedFoldability& foldability) {
  assert(graph.panel_count() >= 2);
  // Clusters rows, not panels: there are never many, however fine the mesh.
  std::vector<int> rows(foldability.rows.begin(), foldability.rows.end());
  std::sort(rows.begin(), rows.end());
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  if (rows.size() > 1) {
    const Labels on_rows = spectral_clusters(
        foldability_affinity(restrict_to(foldability.matrix, rows)), {.parts = 2});
    Labels halves;
    for (const int row : foldability.rows) {
      halves.push_back(on_rows[std::lower_bound(rows.begin(), rows.end(), row) - rows.begin()]);
    }
    halves = connect_parts(graph, foldability, std::move(halves));
    if (part_count(halves) == 2) return halves;
  }
  return halve(mesh, graph);
}

}  // namespace foldwright
