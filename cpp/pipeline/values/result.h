#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fold/motion.h"
#include "mesh/looks.h"
#include "paper/labels.h"
#include "paper/sheets.h"
#include "paper/strips.h"
#include "pipeline/values/piece_names.h"
#include "repair/repair.h"
#include "unfold/net.h"

namespace foldwright {

/// Something a person should know about the result.
using Notice = Message;

/// Why a piece exists: it is a whole part, or a share of a part that has no net, or none that
/// folds, or none that fits the sheet, or one that a person cut.
enum class Cause { kPart, kNoNet, kNoMotion, kSheet, kEdit };

/// The motion that folds a net up.
struct PieceMotion {
  Folding kind = Folding::kUnchecked;
  int root = 0;               ///< the face of the net that stays; in the middle of the tree
  std::vector<double> times;  ///< of the keys, from 0 to 1; empty without a motion
  std::vector<std::vector<double>> angles;  ///< radians per key and edge of the net; 0 for cuts
};

/// One net on paper.
struct Piece {
  int part = 0;
  Cause cause = Cause::kPart;
  std::string name = {};  ///< on paper; all pieces differ
  double angle = 0;       ///< in radians, by which it was turned to lie on its sheet; see `Pin`
  Net net;                ///< millimetres; with the flaps its box starts at (0, 0)
  std::vector<Flap> flaps = {};
  std::vector<Label> labels = {};
  std::vector<Stroke> tape_marks = {};
  std::vector<Stroke> joint_lines = {};  ///< where other pieces stand on its flat panels
  NetCheck check = {};
  PieceMotion motion = {};
  std::vector<std::vector<int>> outlines = {};  ///< see `boundary_walks`
  std::vector<double> necks = {};  ///< lengths of its necks in mm, ascending; see `find_necks`
};

/// Where a net lies on paper, whatever hangs at it: the motion takes it, as `flatten` makes it, to
/// its place from the sheet's lower left. Millimetres.
struct HeldPlace {
  int sheet = 0;
  RigidMotion2 motion;
};

/// A net as plain values that outlive its job, for another job to start from. Faces and edges are
/// those of the result's mesh.
struct SavedNet {
  int part = 0;
  Cause cause = Cause::kPart;
  std::vector<int> faces;  ///< ascending
  std::vector<int> folds;  ///< the first mesh edge of every hinge that folds
  FoldMotion motion;       ///< its shares are in the order of `folds`
  std::optional<HeldPlace> place = {};
};

/// The surface that looks were given for, as it was before it was simplified. Model units, with the
/// mesh's origin.
struct OriginalSurface {
  std::vector<Vec3> positions;
  std::vector<std::array<int, 3>> faces;
};

/// How the model looks, as its file says.
struct ModelLooks {
  FaceLooks faces;                          ///< of the mesh, or of the original
  std::optional<OriginalSurface> original;  ///< only if the mesh was simplified
  std::vector<std::string> material_names;  ///< see `SoupLooks`
  std::vector<std::string> libraries;       ///< see `SoupLooks`
};

struct JobResult {
  std::string file;  ///< name of the file that the model was read from
  Mesh mesh;         ///< repaired, simplified if asked for, model units
  /// How far simplifying moved the surface, in model units: see `largest_deviation`.
  double simplified_deviation = 0;
  std::optional<ModelLooks> looks;  ///< if its file says something of them
  std::vector<Repair> repairs;
  std::vector<int> segmentation;  ///< per face of the file as read: its part, -1 if dropped
  std::vector<int> labels;        ///< per face of the mesh: its part
  int parts = 0;
  std::vector<PartName> names;  ///< those that were chosen, by the numbers of these parts
  std::vector<Piece> pieces;    ///< in the order of gluing
  std::vector<SavedNet> nets;   ///< of the pieces, and then of what is not printed
  SheetLayout sheets;
  FlapCounts flap_counts;
  std::vector<MissedFlap> missed_flaps;
  std::vector<Strip> strips;             ///< loose ones, for edges without a flap; by edge
  int taped = 0;                         ///< edges left for tape
  std::vector<NamedSeam> seams;          ///< what is glued to what; nets are pieces
  int printed_ids = 0;                   ///< see `LabelPlan`
  std::vector<std::string> skipped_ids;  ///< see `LabelPlan`
  std::int64_t moves = 0;                ///< of the tree searches
  int generations = 0;                   ///< of the genetic searches
  std::vector<Notice> notices;
  std::string hash;  ///< of the canonical dump
};

/// Canonical bytes of a result: labels, trees, angles, coordinates and places, as raw numbers in a
/// fixed order. Equal results have equal dumps.
std::string canonical_dump(const JobResult& result);

/// 64-bit FNV-1a hash in hexadecimal.
std::string hash_of(std::string_view bytes);

}  // namespace foldwright
