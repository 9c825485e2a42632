#pragma once

#include <array>
#include <span>
#include <vector>

#include "paper/flap_room.h"

namespace foldwright {

/// On which side of a seam flaps go.
enum class FlapSide {
  kNone,
  kOne,        ///< the same for all that is glued in one go, and the one with more room
  kAlternate,  ///< in turn along the outline of each piece, where both have room
  kBoth
};

/// What flaps look like that follow each other along a run: seams that are glued in one go where
/// the outline bends by at most 45 degrees between them, each at most four flaps' heights long.
enum class FlapStyle {
  kEdge,   ///< like any others
  kRun,    ///< a strip with a narrow notch at each corner
  kZigzag  ///< pointed teeth, one for each short seam, as for curves
};

/// Which sides of one edge get flaps, seen along it; `kUsual` goes by `FlapSide`.
enum class EdgeFlaps { kNone, kLeft, kRight, kBoth, kUsual };

/// A person's choice for one edge of the mesh.
struct FlapChoice {
  int from, to;  ///< vertices of the mesh
  EdgeFlaps flaps;
  double height = 0;  ///< of a full flap there, mm; 0: that of all others
};

/// Shorter cut edges hold by their neighbours, mm.
inline constexpr double kWantedLength = 4;

struct FlapOptions {
  FlapSide side = FlapSide::kOne;
  FlapShape shape = {};
  FlapStyle style = FlapStyle::kRun;
  bool borders = false;  ///< whether open borders of the model get flaps as well
  /// Edges that do not go by `side` and `shape`; of several choices for one edge the last counts.
  /// Edges that are not cut are folds whatever is chosen.
  std::vector<FlapChoice> choices = {};
};

/// A flap of a net.
struct Flap {
  int edge;                 ///< of the net: the first of those it is attached to
  std::array<int, 2> base;  ///< vertices of the net: where those begin and end
  /// Foot, top, top, foot, in the direction of the edges: counter-clockwise. Feet lie on the edges.
  std::array<Vec2, 4> corners;
  double height;
  double angle;  ///< fold angle of its base in radians: valley positive, mountain negative
};

struct MissedFlap {
  int mesh_edge;  ///< that names the seam
  FlapMiss why;
};

/// What came of the wish for flaps, over the seams longer than 4 mm: shorter ones get flaps where
/// there is room, but paper holds without. Seams for which a person chose none want none.
struct FlapCounts {
  int wanted = 0;
  int full = 0, shrunk = 0;                      ///< by the better side
  double wanted_length = 0, missing_length = 0;  ///< mm
  int borders = 0;                               ///< flaps on open borders, at joints or asked for
};

struct FlapPlan {
  std::vector<std::vector<Flap>> flaps;  ///< per net, by edge
  std::vector<MissedFlap> missed;        ///< of the wanted, by mesh edge
  FlapCounts counts;
};

/// Puts flaps to the seams of nets that together make a model, one each: a straight run of edges
/// between two panels has one flap.
///
/// A flap lies within the neighbouring panel, unfolded across its base, and overlaps no face and no
/// other flap of its net. Seams that follow each other between the same two nets have their flaps
/// on one of them as far as that loses no full flap (`flap_sides.h`). Where two flaps meet at a
/// concave corner they share it by half; within a run they go by the style. Seams with little room
/// come first, since room only shrinks; in the end each flap takes what the others left. `nets`: in
/// millimetres, free of overlaps; angles come from `mesh`. Edges with a face in none of the nets
/// get no flap. Where the mesh has joints, what stands there gets a flap to be glued by, which
/// folds until it lies on the host's first face. `keep_off`: per net further convex polygons that
/// flaps must not overlap; or empty. Time: n log n in the cut edges for faces of about equal size.
/// \throw InputError if a choice names an edge that the mesh has not
FlapPlan place_flaps(const Mesh& mesh, std::span<const Net> nets, const FlapOptions& options,
                     std::span<const std::vector<std::vector<Vec2>>> keep_off = {});

}  // namespace foldwright
