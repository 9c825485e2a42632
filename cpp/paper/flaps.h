#pragma once

#include <array>
#include <span>
#include <vector>

#include "paper/room_profile.h"
#include "unfold/net.h"

namespace foldwright {

/// On which side of a cut edge flaps go.
enum class FlapSide {
  kNone,
  kOne,        ///< the one with more room
  kAlternate,  ///< in turn along the outline of each piece, where both have room
  kBoth
};

/// Shorter cut edges hold by their neighbours, mm.
inline constexpr double kWantedLength = 4;

struct FlapOptions {
  FlapSide side = FlapSide::kOne;
  FlapShape shape = {};
};

/// A flap of a net.
struct Flap {
  int edge;  ///< of the net: the one it is attached to
  /// Foot, top, top, foot, in the direction of the edge: counter-clockwise. Feet lie on the edge.
  std::array<Vec2, 4> corners;
  double height;
  double angle;  ///< fold angle of its base in radians: valley positive, mountain negative
};

/// Why a cut edge has no flap.
enum class FlapMiss {
  kShort,   ///< the edge is too short for one
  kThin,    ///< the faces on both sides are too thin to hide one
  kNarrow,  ///< the faces beside it leave too narrow a wedge
  kBlocked  ///< other faces or flaps are in the way
};

struct MissedFlap {
  int mesh_edge;
  FlapMiss why;
};

/// What came of the wish for flaps, over the cut edges between two faces longer than 4 mm: shorter
/// ones get flaps where there is room, but paper holds without.
struct FlapCounts {
  int wanted = 0;
  int full = 0, shrunk = 0;                      ///< by the better side
  double wanted_length = 0, missing_length = 0;  ///< mm
};

struct FlapPlan {
  std::vector<std::vector<Flap>> flaps;  ///< per net, by edge
  std::vector<MissedFlap> missed;        ///< of the wanted, by mesh edge
  FlapCounts counts;
};

/// Puts flaps to the cut edges of nets that together make a model.
///
/// A flap lies within the neighbouring face, unfolded across the edge, and overlaps no face and no
/// other flap of its net. Edges with little room come first, since room only shrinks; each gets the
/// highest flap that fits, on the side where it is higher. `nets`: in millimetres, free of
/// overlaps; angles come from `mesh`. Edges with a face in none of the nets get no flap.
/// `keep_off`: per net further convex polygons that flaps must not overlap; or empty.
/// Time: cut edges times faces of a net.
FlapPlan place_flaps(const Mesh& mesh, std::span<const Net> nets, const FlapOptions& options,
                     std::span<const std::vector<std::vector<Vec2>>> keep_off = {});

}  // namespace foldwright
