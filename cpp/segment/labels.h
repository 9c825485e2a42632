#pragma once

#include <span>
#include <vector>

#include "mesh/dual_graph.h"

namespace foldwright {

/// The part of each panel, from 0 without gaps.
using Labels = std::vector<int>;

/// Renumbers labels by first appearance, without gaps.
Labels renumbered(std::span<const int> labels);

/// One more than the greatest label.
int part_count(std::span<const int> labels);

/// Panels of one part, ascending.
std::vector<int> panels_of(std::span<const int> labels, int part);

/// Per part the area of its panels, in square model units.
std::vector<double> part_areas(const DualGraph& graph, std::span<const int> labels);

/// Per panel the number of its connected piece within its part, from 0 by lowest panel.
std::vector<int> part_pieces(const DualGraph& graph, std::span<const int> labels);

}  // namespace foldwright
