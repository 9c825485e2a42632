#pragma once

#include <cstdint>

#include "fold/foldable.h"
#include "paper/labels.h"
#include "paper/sheets.h"
#include "pipeline/values/piece_names.h"
#include "repair/repair_steps.h"
#include "segment/segment.h"
#include "unfold/heuristics.h"

namespace foldwright {

/// How nets are searched: on spanning trees directly, or by the paper's genetic algorithm.
enum class Solver { kTree, kGenetic };

/// What becomes of nets without a folding motion: split until each has one, kept and reported, or
/// not looked at.
enum class FoldingMode { kOff, kPrefer, kRequire };

/// Unit of the model's coordinates.
enum class Unit { kGuess, kMillimetre, kCentimetre, kMetre, kInch };

/// The axis of the file that points up; the job's mesh is turned so that it is y.
enum class Up { kGuess, kX, kY, kZ };

/// What decides how large the finished model is.
enum class Sizing {
  kFit,     ///< the largest piece just fits the sheet, and nothing is cut again
  kHeight,  ///< extent along y in mm, which is up
  kWidth,   ///< extent along x in mm
  kDepth,   ///< extent along z in mm
  kScale,   ///< factor on the size that the model has in its unit
  kSheets   ///< as large as goes on so many sheets
};

/// The size wished for. Pieces too large for the sheet are cut again, except with `kFit`.
struct SizeOptions {
  Sizing by = Sizing::kFit;
  double value = 0;  ///< mm, a factor, or a number of sheets
  Unit unit = Unit::kGuess;
};

/// Loose strips of paper for edges that get no flap.
enum class GlueStrips {
  kNone,
  kFree,  ///< where the sheets have room beside the pieces
  kAll    ///< on further sheets, too
};

/// A piece that stays where a person put it, named by its part and the lowest of its faces.
struct PinnedPiece {
  int part, face;
  Pin pin;
};

// Options are sorted by what they decide first: whatever was made before that stays as it is when
// they change.

/// What decides the model: how the file becomes a surface.
struct ModelOptions {
  int faces = 0;       ///< simplify to this many triangles first; 0: keep all
  Up up = Up::kGuess;  ///< guessed from the file's format
  /// Fill holes up to so many percent of the model's longest side across; 0: none.
  double fill_holes = 0;
  bool drop_inner = false;  ///< leave out bodies that lie inside others
  bool unite = false;       ///< make one surface of closed bodies that run through each other
  RepairSteps off = {};     ///< steps of the repair that are not done
};

/// What decides the parts of a model.
struct PartOptions {
  int count = 0;  ///< number of parts; 0 estimates it
  Segmenter segmenter = Segmenter::kShape;
  Heuristic heuristic = Heuristic::kSteepestEdge;
  int runs = 400;  ///< learning runs, 1 to 65535
  /// Learn on a simplified proxy above this many faces; 0: never. Proxies of 500 to 1000 faces
  /// segment as well as anything larger, and learning grows with the square.
  int proxy = 1000;
  std::vector<EdgeLock> locks = {};  ///< of the job's mesh; see `lock_edges`
};

/// What decides the nets of parts. Where they are made better to craft (`compaction`), they are so
/// at the size, with the flaps and on the sheets of `PaperOptions`.
struct NetOptions {
  Solver solver = Solver::kTree;
  FoldingMode folding = FoldingMode::kPrefer;
  /// How far apart faces stay while folding, in mean edge lengths: see `make_foldable`.
  double clearance = kClearance;
  bool compaction = true;  ///< make nets better to craft after they were found
};

/// What decides the sheets.
struct PaperOptions {
  SizeOptions size = {};
  SheetOptions sheet = {};
  FlapOptions flaps = {};
  IdPlace ids = IdPlace::kFlap;
  GlueStrips strips = GlueStrips::kNone;
  double min_piece = 0;              ///< bodies that are shorter than this, in mm, are not printed
  std::vector<PartName> names = {};  ///< in a job with a start: of the parts of the earlier result
  std::vector<PinnedPiece> pins = {};
};

/// What a job is asked for.
struct JobOptions {
  ModelOptions model = {};
  PartOptions parts = {};
  NetOptions nets = {};
  PaperOptions paper = {};
  std::uint32_t seed = 1;  ///< of everything that is random
};

/// \throw InputError that names the first option out of its range
void check_options(const JobOptions& options);

}  // namespace foldwright
