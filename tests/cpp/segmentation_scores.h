#pragma once

#include <span>
#include <vector>

#include "mesh/mesh.h"

/// How far two segmentations of one surface differ, as the Princeton Segmentation Benchmark scores
/// them (Chen, Golovinskiy and Funkhouser 2009).
namespace foldwright::testing {

/// 1 - Rand Index: the share of pairs of faces that are together in one segmentation alone, in
/// [0, 1]. One label per face each.
double rand_index_error(std::span<const int> a, std::span<const int> b);

/// Cut Discrepancy: how far the cuts of either segmentation are from those of the other.
struct CutDiscrepancy {
  /// Mean over the cut vertices of each, both directions added, over the mean distance of the
  /// surface's vertices from their centroid.
  double of_cuts = 0;
  /// Sum over the cut vertices of both, over the number of all vertices, and the same distance.
  double of_vertices = 0;
  bool exists = false;  ///< false when one of them has no cut
};

/// Distances run along edges. One label per face of the mesh each.
CutDiscrepancy cut_discrepancy(const Mesh& mesh, std::span<const int> a, std::span<const int> b);

/// How far parts mirror each other: the share of area whose image lies in the image of its part,
/// that is the part on which most of the part's area comes to lie; in [0, 1]. Per panel its label,
/// its area, and the panel where its mirror image is.
double mirror_symmetry(std::span<const int> labels, std::span<const double> areas,
                       std::span<const int> images);

}  // namespace foldwright::testing
