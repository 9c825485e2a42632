#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "paper/seams.h"

namespace foldwright {

/// What tells people which edge goes where.
struct SeamId {
  /// What is printed at the two sides: where another piece is met its name and a number of the
  /// pair (`C3` on A, `A3` on C); within a piece a number of the piece.
  std::array<std::string, 2> texts;
  /// The same for lists, where no piece is around it: `A-C:3`, `A:3`. All differ.
  std::string name;
};

/// The ids of seams: they count from 1 along the outlines, piece by piece, for each pair of pieces
/// and within each piece; and after those the joints. `names`: of the nets.
std::vector<SeamId> name_seams(std::span<const Net> nets, std::span<const std::string> names,
                               std::span<const Seam> seams, std::span<const Seam> joints = {});

}  // namespace foldwright
