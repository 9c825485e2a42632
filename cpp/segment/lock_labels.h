#pragma once

#include "segment/labels.h"

namespace foldwright {

/// Per panel the lowest panel of those that folds hold it together with that are never to be cut.
std::vector<int> locked_groups(const DualGraph& graph);

/// Whether such folds hold all panels together, so that nothing can be cut.
bool is_held_together(const DualGraph& graph);

/// Labels in which no fold that is never to be cut lies between two parts.
///
/// Panels that such folds hold together go as a whole to the part that has most of their area, the
/// lower one of equals. What a part loses its connection to by that goes to the neighbour with the
/// longest border to it. Parts stay connected, but one may vanish: those left are then renumbered.
/// Without such folds the labels are returned as they are. Cost: n log n in the panels for each
/// piece that is moved. \pre parts are connected
Labels keep_locked_together(const DualGraph& graph, Labels labels);

/// Halves, 0 and 1, of a connected graph between which no such fold lies, where those of some
/// `labels` are lost by that. \pre the graph is not held together
Labels halve_between_locks(const DualGraph& graph, Labels labels);

}  // namespace foldwright
