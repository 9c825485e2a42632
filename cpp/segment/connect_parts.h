#pragma once

#include "segment/foldability.h"
#include "segment/labels.h"

namespace foldwright {

/// Makes every part connected: panels apart from the largest piece (by area) of their part go to
/// the neighbouring part of greatest co-foldability, the sum of area times M over the faces
/// of its largest piece [paper, Eq. (1)].
///
/// `foldability`: one row per panel. A part never vanishes. Pieces that touch no other part
/// (another component of the mesh) become parts of their own. Cost: rows of M times stray panels.
Labels connect_parts(const DualGraph& graph, const CarriedFoldability& foldability, Labels labels);

}  // namespace foldwright
