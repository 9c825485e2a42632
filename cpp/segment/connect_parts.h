#pragma once

#include "segment/foldability.h"
#include "segment/labels.h"

namespace foldwright {

/// Makes every part connected: panels apart from the largest piece (by area) of their part go to
/// the neighbouring part of greatest co-foldability, sum over its faces of area times M [paper, Eq.
/// (1)].
///
/// `matrix`: one row per panel. Repeats until all parts are connected; a part never vanishes.
/// Pieces that touch no other part (another component of the mesh) become parts of their own.
Labels connect_parts(const DualGraph& graph, const FoldabilityMatrix& matrix, Labels labels);

}  // namespace foldwright
