#pragma once

#include <cstdint>

#include "fold/foldable.h"
#include "paper/sheets.h"
#include "segment/segment.h"
#include "unfold/heuristics.h"

namespace foldwright {

/// How nets are searched: on spanning trees directly, or by the paper's genetic algorithm.
enum class Solver { kTree, kGenetic };

/// What becomes of nets without a folding motion: split until each has one, kept and reported, or
/// not looked at.
enum class FoldingMode { kOff, kPrefer, kRequire };

/// What a job is asked for.
struct JobOptions {
  int parts = 0;  ///< number of parts; 0 estimates it
  Heuristic heuristic = Heuristic::kSteepestEdge;
  Segmenter segmenter = Segmenter::kShape;
  Solver solver = Solver::kTree;
  FoldingMode folding = FoldingMode::kPrefer;
  /// How far apart faces stay while folding, in mean edge lengths: see `make_foldable`.
  double clearance = kClearance;
  int runs = 400;  ///< learning runs, 1 to 65535
  /// Learn on a simplified proxy above this many faces; 0: never. Proxies of 500 to 1000 faces
  /// segment as well as anything larger, and learning grows with the square.
  int proxy = 1000;
  std::uint32_t seed = 1;
  int faces = 0;  ///< simplify to this many triangles first; 0: keep all
  SheetOptions sheet = {};
};

/// \throw InputError that names the first option out of its range
void check_options(const JobOptions& options);

}  // namespace foldwright
