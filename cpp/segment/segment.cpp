#include "segment/segment.h"

#include <algorithm>
#include <cassert>
#include <numeric>

#include "segment/connect_parts.h"
#include "segment/merge.h"
#include "segment/spectral.h"

namespace foldwright {
namespace {

std::vector<int> panels_of(const Labels& labels, int part) {
  std::vector<int> panels;
  for (int panel = 0; panel < static_cast<int>(labels.size()); ++panel) {
    if (labels[panel] == part) panels.push_back(panel);
  }
  return panels;
}

/// The part of largest area that has more than one panel; -1 when there is none.
int largest_divisible(const DualGraph& graph, const Labels& labels) {
  std::vector<double> area(part_count(labels), 0);
  std::vector<int> size(area.size(), 0);
  for (int panel = 0; panel < graph.panel_count(); ++panel) {
    area[labels[panel]] += graph.areas[panel];
    ++size[labels[panel]];
  }
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

}  // namespace

Labels segment(const Mesh& mesh, const DualGraph& graph, const FoldabilityMatrix& matrix,
               const SegmentOptions& options) {
  assert(options.parts <= graph.panel_count());
  if (options.segmenter == Segmenter::kMerge) {
    return merge_clusters(mesh, graph, matrix, {.parts = options.parts});
  }
  Labels labels = spectral_clusters(matrix, {.parts = options.parts, .seed = options.seed});
  std::vector<int> rows(graph.panel_count());
  std::iota(rows.begin(), rows.end(), 0);
  return connect_parts(graph, {matrix, rows}, std::move(labels));
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

Labels split_in_two(const Mesh& mesh, const DualGraph& graph,
                    const CarriedFoldability& foldability) {
  assert(graph.panel_count() >= 2);
  // Spectral bisection, because the last merge often sets a few outliers apart from all the rest.
  const FoldabilityMatrix matrix = restrict_to(foldability.matrix, foldability.rows);
  std::vector<int> rows(graph.panel_count());
  std::iota(rows.begin(), rows.end(), 0);
  const Labels halves =
      connect_parts(graph, {matrix, rows}, spectral_clusters(matrix, {.parts = 2}));
  if (part_count(halves) == 2) return halves;
  return merge_clusters(mesh, graph, matrix, {.parts = 2});
}

}  // namespace foldwright
