#pragma once

#include "pipeline/nets/net_trees.h"

namespace foldwright {

/// Makes one edit. Nets that come of it keep their place on paper where they are, and their motion
/// if it is still proved; `scale`: millimetres per model unit of these places.
///
/// Returns the edit of whole parts that it amounts to, if some are merged by it: `labels` and the
/// nets' parts have their new numbers by then. Changes nothing when it throws.
/// Cost: linear in the faces for a cut and between two nets; times the folds of the loop within
/// one. \throw InputError whose code says why the edit cannot be made, with the faces in the way:
/// "no-edge", "inside-panel", "open-border", "already-cut", "already-joined", "not-in-loop",
/// "overlap", "no-face", "no-part", "not-touching", "would-fall-apart", "locked"
std::optional<PartEdit> apply_net_edit(const Surface& surface, double scale, const NetEdit& edit,
                                       EarlierNets& nets);

/// Locks without those of edges that `edits` lock anew.
std::vector<EdgeLock> locks_before(std::span<const EdgeLock> locks, std::span<const NetEdit> edits);

}  // namespace foldwright
