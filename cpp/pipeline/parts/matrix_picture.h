#pragma once

#include "pipeline/values/events.h"

namespace foldwright {

/// The matrix averaged down to at most 256 rows [paper, Fig. 7]. With `labels`, one per row, rows
/// are sorted by label and the blocks of the labels are told.
MatrixPicture make_matrix_picture(const FoldabilityMatrix& matrix,
                                  std::span<const int> labels = {});

}  // namespace foldwright
