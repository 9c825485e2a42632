#pragma once

#include <span>

#include "mesh/dual_graph.h"

namespace foldwright {

/// Whether all panels of a graph reach each other over hinges; false for a graph without panels.
bool is_connected(const DualGraph& graph);

/// Whether the part of a panel is still connected, and not empty, without it. Cost: as many panels
/// as the part has, at most. `labels`: the part of each panel. \pre the part is connected with it
bool stays_connected(const DualGraph& graph, std::span<const int> labels, int panel);

}  // namespace foldwright
